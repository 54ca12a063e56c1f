// The density of a texel is in proportion to the bilinear lookup's luminance averaged over it, so it is
// positive wherever the lookup is: the environment is never missed, and its bright spots are found in
// proportion.
#include "render/environment_table.hpp"

#include "base/error.hpp"
#include "render/alias_table.hpp"
#include "render/luminance.hpp"

#include <algorithm>
#include <bit>
#include <cfloat>
#include <cmath>
#include <numbers>
#include <string>
#include <tbb/parallel_for.h>

namespace ajar {
namespace {

float clean(float x) { return x > 0 ? std::min(x, FLT_MAX) : 0.0f; } // NaN compares false

glm::vec3 clean(const glm::vec3& v) { return {clean(v.x), clean(v.y), clean(v.z)}; }

// Luminance of the scaled map averaged horizontally over the bilinear lookup: a texel's own value counts 6/8
// in its cell, each neighbour's 1/8 (the mean of the tent over half its width).
std::vector<double> smoothed_rows(const Environment& environment) {
    const std::size_t width = environment.width;
    std::vector<double> smooth(width * environment.height);
    tbb::parallel_for(std::size_t{0}, std::size_t{environment.height}, [&](std::size_t y) {
        const glm::vec3* row = &environment.radiance[y * width];
        std::vector<double> plain(width);
        for (std::size_t x = 0; x < width; ++x)
            plain[x] = luminance(glm::dvec3(clean(row[x])) * glm::dvec3(clean(environment.scale)));
        for (std::size_t x = 0; x < width; ++x)
            smooth[y * width + x] =
                0.75 * plain[x] + 0.125 * (plain[(x + width - 1) % width] + plain[(x + 1) % width]);
    });
    return smooth;
}

// Words of a tree's level whose nodes span 4^level entries.
std::uint32_t level_nodes(std::uint32_t count, std::uint32_t level) {
    return ((count - 1) >> (2 * level)) + 1;
}

} // namespace

double environment_texel_solid_angle(std::uint32_t width, std::uint32_t height, std::uint32_t row) {
    // 2 pi (cos a - cos b) / width, as a product that does not cancel.
    const double step = std::numbers::pi / height;
    return 4 * std::numbers::pi / width * std::sin((row + 0.5) * step) * std::sin(0.5 * step);
}

void append_search_trees(std::vector<glm::uvec4>& words, const std::vector<std::uint32_t>& masses,
                         std::uint32_t rows, std::uint32_t count) {
    const auto levels = static_cast<std::uint32_t>((std::bit_width(std::max(count, 2u) - 1u) - 1) / 2 + 1);
    std::size_t first = words.size();
    std::size_t size = first;
    for (std::uint32_t level = levels; level > 0; --level)
        size += std::size_t{rows} * level_nodes(count, level);
    words.resize(size);
    for (std::uint32_t level = levels; level > 0; --level) {
        const std::uint32_t nodes = level_nodes(count, level);
        const std::uint32_t shift = 2 * (level - 1);
        tbb::parallel_for(std::uint32_t{0}, rows, [&](std::uint32_t row) {
            const std::uint32_t* mass = masses.data() + std::size_t{row} * count;
            glm::uvec4* out = words.data() + first + std::size_t{row} * nodes;
            std::uint32_t sum = 0;
            std::uint64_t entry = 0;
            for (std::uint32_t child = 0; child < 4 * nodes; ++child) {
                for (; entry < std::min<std::uint64_t>(std::uint64_t{child} << shift, count); ++entry)
                    sum += mass[entry];
                out[child / 4][static_cast<int>(child % 4)] = sum;
            }
        });
        first += std::size_t{rows} * nodes;
    }
}

EnvironmentTable build_environment_table(const Environment& environment) {
    EnvironmentTable table;
    if (environment.radiance.empty()) return table;
    table.width = environment.width;
    table.height = environment.height;
    if (std::max(table.width, table.height) > 65536)
        throw Error("environment '" + environment.name + "': more than 65536 texels across (scale it down)");
    const std::size_t width = table.width;
    const std::size_t height = table.height;
    const std::vector<double> smooth = smoothed_rows(environment);

    std::vector<double> row_power(height);
    std::vector<std::uint32_t> columns(width * height);
    tbb::parallel_for(std::size_t{0}, height, [&](std::size_t y) {
        const std::size_t above = y > 0 ? y - 1 : 0;
        const std::size_t below = std::min(y + 1, height - 1);
        std::vector<double> weights(width);
        double sum = 0;
        for (std::size_t x = 0; x < width; ++x) {
            weights[x] = 0.75 * smooth[y * width + x] +
                         0.125 * (smooth[above * width + x] + smooth[below * width + x]);
            sum += weights[x];
        }
        row_power[y] =
            sum * environment_texel_solid_angle(table.width, table.height, static_cast<std::uint32_t>(y));
        const std::vector<std::uint32_t> masses = apportion(weights, PROBABILITY_UNITS);
        std::copy(masses.begin(), masses.end(), columns.begin() + static_cast<std::ptrdiff_t>(y * width));
    });
    const std::vector<std::uint32_t> rows = apportion(row_power, PROBABILITY_UNITS);

    table.words.resize(width * height);
    for (std::size_t y = 0; y < height; ++y) {
        const double solid_angle =
            environment_texel_solid_angle(table.width, table.height, static_cast<std::uint32_t>(y));
        const double row_density =
            rows[y] / double{PROBABILITY_UNITS} / double{PROBABILITY_UNITS} / solid_angle;
        for (std::size_t x = 0; x < width; ++x) {
            const glm::vec3 radiance = clean(environment.radiance[y * width + x]);
            const auto density = static_cast<float>(row_density * columns[y * width + x]);
            table.words[y * width + x] = {
                std::bit_cast<std::uint32_t>(radiance.x), std::bit_cast<std::uint32_t>(radiance.y),
                std::bit_cast<std::uint32_t>(radiance.z), std::bit_cast<std::uint32_t>(density)};
        }
    }
    append_search_trees(table.words, rows, 1, table.height);
    append_search_trees(table.words, columns, table.height, table.width);
    return table;
}

glm::dvec3 mean_radiance(const Environment& environment) {
    const glm::dvec3 scale(clean(environment.scale));
    if (environment.radiance.empty()) return scale;
    glm::dvec3 total(0);
    for (std::uint32_t y = 0; y < environment.height; ++y) {
        glm::dvec3 row(0);
        for (std::uint32_t x = 0; x < environment.width; ++x)
            row += glm::dvec3(clean(environment.radiance[std::size_t{y} * environment.width + x]));
        total += row * environment_texel_solid_angle(environment.width, environment.height, y);
    }
    return scale * total / (4 * std::numbers::pi);
}

} // namespace ajar
