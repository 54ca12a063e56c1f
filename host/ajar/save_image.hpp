// Images to files, the format by the name's extension.
#pragma once

#include "image/image.hpp"

#include <filesystem>
#include <string>

namespace ajar {

struct SaveOptions {
    std::string tonemap = "linear"; // .png, .jpg: linear, agx, aces or neutral
    float exposure = 0;             // .png, .jpg: EV, radiance is multiplied by 2^exposure first
    bool full_floats = false; // .exr: 32 bits for every layer, not only where half floats are too coarse
};

// .exr: every layer and the metadata. .png, .jpg: the beauty, tone-mapped, sRGB. .hdr: the beauty, RGBE.
// The file is replaced in one step or, on an Error, left as it was. The same image gives the same bytes.
void save_image(const std::filesystem::path& path, const Image& image, const SaveOptions& options = {});

// Throws the Error that save_image would, as far as the name and the options can tell, before hours of
// rendering.
void check_save(const std::filesystem::path& path, const SaveOptions& options = {});

} // namespace ajar
