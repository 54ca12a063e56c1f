// Charts laid out in one square texture, all at the same number of texels per metre.
#pragma once

#include "bake/charts.hpp"

namespace ajar {

// Texels around each chart that are filled from its border: two of them keep bilinear filters, and the
// second level of a mip map, among the chart's own light.
inline constexpr std::uint32_t GUTTER = 2;

struct Atlas {
    Charts charts;
    std::uint32_t side = 0; // texels
    double texels_per_metre = 0;
    std::vector<glm::uvec2> places;                       // by chart: the least texel, gutter included
    std::vector<glm::uvec2> sizes;                        // by chart: texels, gutter included
    std::vector<std::array<glm::dvec2, 3>> texel_corners; // by triangle: in texels, (0, 0) the atlas' corner

    // As TEXCOORD_1 holds it, row 0 at the top.
    glm::vec2 uv(std::uint32_t triangle, std::size_t corner) const {
        return glm::vec2(texel_corners[triangle][corner] / static_cast<double>(side));
    }
};

// As many texels per metre as fit. Throws Error where `side` is too small for so many charts.
Atlas make_atlas(Charts charts, std::uint32_t side);

} // namespace ajar
