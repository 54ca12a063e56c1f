// Pictures from files and from memory. The format is told by the first bytes, not by the name. Whatever is
// missing, a folder, corrupt, truncated or too large gives an Error of one line that starts with the file's
// name.
#pragma once

#include "image/image.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <glm/glm.hpp>
#include <span>
#include <string>
#include <vector>

namespace ajar {

// OpenEXR with its layers (in order of name, the beauty first) and text attributes, Radiance HDR, and PNG,
// JPEG and WebP with the sRGB curve undone and alpha multiplied in (range = display). The beauty layer always
// has R, G, B, A. Of an OpenEXR file of several parts the first is read. Limits: 2^28 pixels, 2^32 values.
Image read_image(const std::filesystem::path& path);

// Eight-bit RGBA, row 0 at the top, as stored: no colour conversion, alpha not multiplied in. Grey is copied
// to R, G and B, missing alpha is 255, sixteen bits are rounded to eight.
struct DecodedImage {
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::vector<std::uint8_t> rgba; // width * height * 4
};

inline constexpr std::uint64_t MAX_TEXTURE_PIXELS = std::uint64_t{1} << 26;

// A PNG, JPEG or WebP file in memory. `name` starts the errors' lines.
DecodedImage decode_rgba8(std::span<const std::byte> bytes, const std::string& name,
                          std::uint64_t max_pixels = MAX_TEXTURE_PIXELS);

struct EnvironmentImage {
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::vector<glm::vec3> radiance; // width * height, finite, not negative, row 0 at the top
};

// A Radiance HDR or OpenEXR file. Negative values become 0; a NaN or an infinity is an Error naming the
// pixel.
EnvironmentImage read_environment(const std::filesystem::path& path);

} // namespace ajar
