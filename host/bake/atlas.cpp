#include "bake/atlas.hpp"

#include "bake/packing.hpp"
#include "base/error.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace ajar {

namespace {

// A chart's sides lie on the centres of texels, so that a bilinear filter within it sees none but those that
// it covers. Lengths are rounded up to whole texels for that, by less than one.
double texels_between(double extent, double per_metre) {
    return std::max(std::ceil(extent * per_metre), 1.0);
}

std::vector<glm::uvec2> chart_sizes(const Charts& charts, double per_metre, std::uint32_t side) {
    std::vector<glm::uvec2> sizes;
    for (const Chart& chart : charts.charts) {
        glm::uvec2& size = sizes.emplace_back();
        for (int k = 0; k < 2; ++k) // one that is too long may be as long as it likes
            size[k] = static_cast<std::uint32_t>(
                std::min<double>(texels_between(chart.extent[k], per_metre) + 1 + 2 * GUTTER, side + 1.0));
    }
    return sizes;
}

// Bisects for the greatest density that fits, to a thousandth. More is not always harder for a packer, but
// nearly so.
double best_density(const Charts& charts, std::uint32_t side) {
    double area = 0;
    for (const Chart& chart : charts.charts) area += chart.extent.x * chart.extent.y;
    const auto fits = [&](double density) {
        return pack(chart_sizes(charts, density, side), side).has_value();
    };
    if (!fits(0))
        throw Error(fmt::format("an atlas of {} x {} texels is too small for {} charts (give a larger one)",
                                side, side, charts.charts.size()));
    double high = side / std::sqrt(area); // texels for all of it, and none for gutters
    double low = high / 1024;
    if (!fits(low)) return 0; // a texel or two for each chart
    while (high > 1.001 * low) {
        const double middle = std::sqrt(low * high);
        (fits(middle) ? low : high) = middle;
    }
    return low;
}

} // namespace

Atlas make_atlas(Charts charts, std::uint32_t side) {
    Atlas atlas;
    atlas.side = side;
    atlas.texels_per_metre = best_density(charts, side);
    atlas.sizes = chart_sizes(charts, atlas.texels_per_metre, side);
    atlas.places = *pack(atlas.sizes, side);
    atlas.charts = std::move(charts);
    atlas.texel_corners.resize(atlas.charts.triangles.size());
    for (std::size_t t = 0; t < atlas.texel_corners.size(); ++t) {
        const std::uint32_t c = atlas.charts.chart_of[t];
        const glm::dvec2 texels = glm::dvec2(atlas.sizes[c] - 1u - 2 * GUTTER);
        const glm::dvec2 first = glm::dvec2(atlas.places[c] + GUTTER) + 0.5;
        for (std::size_t k = 0; k < 3; ++k)
            atlas.texel_corners[t][k] =
                first + atlas.charts.flat_corners[t][k] / atlas.charts.charts[c].extent * texels;
    }
    return atlas;
}

} // namespace ajar
