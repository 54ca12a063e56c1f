// The colour map magma (Stefan van der Walt and Nathaniel Smith, 2015, CC0), every fifteenth of its 256
// entries as 8-bit sRGB; straight lines between them stay within 3 of 255 of the rest.
#include "image/compare.hpp"
#include "image/srgb.hpp"

#include <algorithm>
#include <array>

namespace ajar {
namespace {

constexpr std::array<std::array<std::uint8_t, 3>, 18> magma{{
    {0, 0, 4},
    {9, 7, 32},
    {26, 16, 66},
    {49, 17, 101},
    {74, 16, 121},
    {98, 25, 128},
    {121, 34, 130},
    {145, 43, 129},
    {170, 51, 125},
    {194, 59, 117},
    {217, 70, 107},
    {236, 88, 96},
    {247, 114, 92},
    {252, 142, 100},
    {254, 170, 116},
    {254, 198, 138},
    {253, 226, 163},
    {252, 253, 191},
}};

} // namespace

Image heat_map(const Comparison& comparison) {
    Image image{comparison.width, comparison.height, {}, {}, Range::display};
    Layer& layer = image.add("", {"R", "G", "B", "A"});
    for (std::size_t i = 0; i < image.pixel_count(); ++i) {
        const float place = std::clamp(comparison.flip_error[i], 0.0f, 1.0f) * (magma.size() - 1);
        const std::size_t below = std::min(static_cast<std::size_t>(place), magma.size() - 2);
        const float between = place - static_cast<float>(below);
        for (std::size_t c = 0; c < 3; ++c) {
            const float encoded = static_cast<float>(magma[below][c]) * (1 - between) +
                                  static_cast<float>(magma[below + 1][c]) * between;
            layer.pixels[4 * i + c] = srgb_decode(encoded / 255);
        }
        layer.pixels[4 * i + 3] = 1;
    }
    return image;
}

} // namespace ajar
