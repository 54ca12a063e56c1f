// A float image of named layers: what the film produces, the files hold and the comparison reads. The beauty
// layer is named "" and has the channels R, G, B, A: linear Rec. 709 radiance, premultiplied by alpha
// (OpenEXR's convention). Other layers: "variance" (R, G, B: variance of the pixel's mean), "albedo",
// "normal", "position", "depth" (Z), ...
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace ajar {

struct Layer {
    std::string name;
    std::uint32_t channels = 0;
    std::vector<std::string> channel_names; // one per channel, without the layer's name
    std::vector<float> pixels;              // width * height * channels, interleaved, row 0 at the top
    // Largest relative error of a stored value: 2^-24 for 32-bit floats, 2^-11 for half floats. The
    // comparison allows it.
    float rounding = 0x1p-24f;
};

// What the beauty layer's numbers mean: radiance without bound, or what an 8- or 16-bit file shows (in [0,
// 1]; the sRGB curve is undone).
enum class Range : std::uint8_t { scene, display };

struct Image {
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::vector<Layer> layers;
    std::vector<std::pair<std::string, std::string>> metadata; // written to and read from OpenEXR only
    Range range = Range::scene;

    // The layer of that name, or nullptr.
    const Layer* find(std::string_view name) const;
    Layer* find(std::string_view name);
    // Appends a layer of zeros; the reference lives until the next layer is added.
    Layer& add(std::string name, std::vector<std::string> channel_names);
    std::size_t pixel_count() const { return std::size_t{width} * height; }
};

// The beauty layer (at least R, G, B), or Error starting with `name`, listing the layers that are there.
const Layer& beauty(const Image& image, std::string_view name);

} // namespace ajar
