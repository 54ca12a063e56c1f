#include "image/webp.hpp"

#include "base/error.hpp"

#include <cstdint>
#include <fmt/format.h>

namespace ajar {
namespace {

std::uint64_t little_endian(std::span<const std::byte> bytes) {
    std::uint64_t value = 0;
    for (std::size_t i = 4; i-- > 0;) value = value << 8 | std::to_integer<std::uint64_t>(bytes[i]);
    return value;
}

void put_header(std::vector<std::byte>& out, std::string_view type, std::uint64_t size) {
    for (const char c : type) out.push_back(static_cast<std::byte>(c));
    for (int shift = 0; shift < 32; shift += 8) out.push_back(static_cast<std::byte>(size >> shift & 0xff));
}

// "RIFF" size "WEBP", then the one chunk, padded to an even length.
std::vector<std::byte> wrap(std::string_view type, std::span<const std::byte> data) {
    const std::size_t padded = data.size() + data.size() % 2;
    std::vector<std::byte> out;
    put_header(out, "RIFF", 4 + 8 + padded);
    for (const char c : std::string_view("WEBP")) out.push_back(static_cast<std::byte>(c));
    put_header(out, type, data.size());
    out.insert(out.end(), data.begin(), data.end());
    out.resize(20 + padded);
    return out;
}

} // namespace

std::vector<std::byte> opaque_webp(std::span<const std::byte> bytes, std::string_view name) {
    bool alpha_chunk = false;
    for (std::size_t at = 12; at + 8 <= bytes.size();) {
        const std::string_view type(reinterpret_cast<const char*>(bytes.data()) + at, 4);
        const std::uint64_t size = little_endian(bytes.subspan(at + 4));
        if (size > bytes.size() - at - 8) break;
        const auto data = bytes.subspan(at + 8, size);
        if (type == "ANMF") throw Error(fmt::format("{}: is an animated WebP image", name));
        if (type == "ALPH") alpha_chunk = true;
        if (type == "VP8 ") return alpha_chunk ? wrap(type, data) : std::vector<std::byte>{};
        if (type == "VP8L" && size > 5) {
            // After the signature byte: 14 bits width - 1, 14 bits height - 1, "alpha is used", 3 bits
            // version.
            if ((data[4] & std::byte{0x10}) == std::byte{0}) return {};
            std::vector<std::byte> file = wrap(type, data);
            file[20 + 4] &= ~std::byte{0x10};
            return file;
        }
        at += 8 + size + size % 2;
    }
    throw Error(fmt::format("{}: WebP without image data", name));
}

} // namespace ajar
