// Pictures to files, the format by the name's extension. The same pixels and metadata give the same bytes: no
// clock, no host, no software name. A file is replaced in one step or left as it was.
#pragma once

#include "image/image.hpp"
#include "image/tonemap.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

namespace ajar {

enum class ExrFloats : std::uint8_t { half, full }; // full: 32 bits for every layer
enum class Alpha : std::uint8_t { opaque, keep };   // keep: PNG with alpha, colours not multiplied by it

struct WriteOptions {
    ExrFloats exr_floats = ExrFloats::half;
    Tonemap tonemap{}; // .png, .jpg
    Alpha alpha = Alpha::opaque;
    int jpeg_quality = 95; // 1 to 100, colours not subsampled
};

// .exr: one part, scan lines, ZIP; every layer as channels "layer.R", metadata as text attributes. With half
// floats the layers "variance", "position", "depth", "samples" and those ending in "_id" stay at 32 bits, and
// values beyond half's 65504 are cut off there.
// .png, .jpg, .jpeg: the beauty layer, tone-mapped, sRGB, 8 bits. .hdr: the beauty layer, RGBE.
void write_image(const std::filesystem::path& path, const Image& image, const WriteOptions& options = {});

// A texture as a PNG file in memory: eight bits a channel as they are, row 0 at the top, 1 (grey), 3 or 4
// channels, alpha apart. decode_rgba8 gives the same values back.
std::vector<std::byte> encode_png(std::uint32_t width, std::uint32_t height, std::uint32_t channels,
                                  std::span<const std::uint8_t> values);

// Throws the Error that write_image would, as far as the name can tell: to be called before hours of
// rendering. The extension is known, the folder exists and is writable, the name is not a folder's.
void check_output_name(const std::filesystem::path& path);

} // namespace ajar
