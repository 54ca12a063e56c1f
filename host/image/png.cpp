#include "image/png.hpp"

#include "base/error.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <fmt/format.h>

namespace ajar {
namespace {

// CRC-32 of PNG (W3C 2003, annex D): reflected polynomial 0xedb88320.
std::uint32_t crc32(std::span<const std::byte> bytes) {
    static constexpr auto table = [] {
        std::array<std::uint32_t, 256> entries{};
        for (std::uint32_t i = 0; i < 256; ++i) {
            entries[i] = i;
            for (int bit = 0; bit < 8; ++bit)
                entries[i] = entries[i] >> 1 ^ (entries[i] & 1 ? 0xedb88320u : 0u);
        }
        return entries;
    }();
    std::uint32_t crc = ~0u;
    for (const std::byte byte : bytes)
        crc = crc >> 8 ^ table[(crc ^ std::to_integer<std::uint32_t>(byte)) & 0xff];
    return ~crc;
}

std::uint32_t big_endian(std::span<const std::byte> bytes) {
    std::uint32_t value = 0;
    for (const std::byte byte : bytes.first(4)) value = value << 8 | std::to_integer<std::uint32_t>(byte);
    return value;
}

} // namespace

std::vector<std::byte> essential_png(std::span<const std::byte> bytes, std::string_view name) {
    constexpr std::array<std::string_view, 5> kept{"IHDR", "PLTE", "tRNS", "IDAT", "IEND"};
    std::vector<std::byte> result(bytes.begin(), bytes.begin() + 8);
    bool palette = false, pixels = false;
    for (std::size_t at = 8;;) { // a chunk: length of the data, type, data, CRC of type and data
        const std::size_t left = bytes.size() - at;
        const std::size_t length = left >= 12 ? big_endian(bytes.subspan(at)) : 0;
        if (left < 12 || length > left - 12)
            throw Error(
                fmt::format("{}: PNG data ends before the image does ({} bytes)", name, bytes.size()));
        const auto chunk = bytes.subspan(at, length + 12);
        const std::string_view type(reinterpret_cast<const char*>(chunk.data()) + 4, 4);
        if (std::find(kept.begin(), kept.end(), type) != kept.end()) {
            if (crc32(chunk.subspan(4, length + 4)) != big_endian(chunk.last(4)))
                throw Error(fmt::format("{}: corrupt PNG: wrong checksum at byte {}", name, at));
            result.insert(result.end(), chunk.begin(), chunk.end());
        } else if (type[0] >= 'A' &&
                   type[0] <= 'Z') { // upper case: without it the picture would be wrong (5.4)
            throw Error(fmt::format("{}: corrupt PNG: unknown critical chunk at byte {}", name, at));
        }
        palette |= type == "PLTE";
        pixels |= type == "IDAT";
        if (type == "IEND") break;
        at += chunk.size();
    }
    const bool needs_palette = bytes[25] == std::byte{3}; // IHDR's colour type
    if (!pixels || (needs_palette && !palette))
        throw Error(fmt::format("{}: corrupt PNG: has no {}", name, pixels ? "palette" : "pixels"));
    return result;
}

} // namespace ajar
