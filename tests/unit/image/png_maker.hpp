// PNG files written by hand, so that tests can have any colour type and depth, a lie in the header, or a
// cut-off end. Stored deflate blocks (RFC 1951, 3.2.4), CRC-32 and Adler-32 as PNG and zlib want them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string_view>
#include <vector>

namespace ajar::test {

using Bytes = std::vector<std::byte>;

inline void put(Bytes& out, std::uint64_t value, int count) {
    for (int i = count - 1; i >= 0; --i) out.push_back(static_cast<std::byte>(value >> (8 * i) & 0xff));
}

inline std::uint32_t crc32(const std::byte* data, std::size_t size) {
    std::uint32_t crc = 0xffffffffu;
    for (std::size_t i = 0; i < size; ++i) {
        crc ^= std::to_integer<std::uint32_t>(data[i]);
        for (int bit = 0; bit < 8; ++bit) crc = crc >> 1 ^ (crc & 1 ? 0xedb88320u : 0u);
    }
    return ~crc;
}

inline void put_chunk(Bytes& out, std::string_view type, const Bytes& data) {
    put(out, data.size(), 4);
    const std::size_t start = out.size();
    for (const char c : type) out.push_back(static_cast<std::byte>(c));
    out.insert(out.end(), data.begin(), data.end());
    put(out, crc32(out.data() + start, out.size() - start), 4);
}

struct Png {
    std::uint32_t width = 0, height = 0;
    int depth = 8;                       // bits
    int color_type = 6;                  // 0 grey, 2 RGB, 3 palette, 4 grey and alpha, 6 RGBA
    std::vector<std::uint8_t> samples{}; // the scan lines' bytes without their filter bytes
    std::vector<std::uint8_t> palette{}; // RGB
    std::vector<std::uint8_t> transparency{};
};

inline Bytes make_png(const Png& png) {
    Bytes raw;
    const std::size_t row = png.height ? png.samples.size() / png.height : 0;
    for (std::size_t y = 0; y < png.height && row > 0; ++y) {
        raw.push_back(std::byte{0});
        for (std::size_t i = 0; i < row; ++i) raw.push_back(static_cast<std::byte>(png.samples[y * row + i]));
    }
    std::uint32_t a = 1, b = 0;
    for (const std::byte byte : raw) {
        a = (a + std::to_integer<std::uint32_t>(byte)) % 65521;
        b = (b + a) % 65521;
    }
    Bytes zlib;
    put(zlib, 0x7801, 2);
    put(zlib, 1, 1); // last block, stored; at most 65535 bytes
    for (const std::uint64_t length : {raw.size(), ~raw.size()}) {
        put(zlib, length & 0xff, 1);
        put(zlib, length >> 8 & 0xff, 1);
    }
    zlib.insert(zlib.end(), raw.begin(), raw.end());
    put(zlib, b << 16 | a, 4);

    const auto bytes = [](const std::vector<std::uint8_t>& values) {
        Bytes out(values.size());
        if (!values.empty()) std::memcpy(out.data(), values.data(), values.size());
        return out;
    };
    Bytes header, out;
    put(header, png.width, 4);
    put(header, png.height, 4);
    put(header, static_cast<std::uint64_t>(png.depth), 1);
    put(header, static_cast<std::uint64_t>(png.color_type), 1);
    put(header, 0, 3);
    put(out, 0x89504e470d0a1a0au, 8);
    put_chunk(out, "IHDR", header);
    if (!png.palette.empty()) put_chunk(out, "PLTE", bytes(png.palette));
    if (!png.transparency.empty()) put_chunk(out, "tRNS", bytes(png.transparency));
    put_chunk(out, "IDAT", zlib);
    put_chunk(out, "IEND", {});
    return out;
}

} // namespace ajar::test
