// The density of a cell is in proportion to the bilinear lookup's luminance averaged over it, so it is
// positive wherever the lookup is: the environment is never missed, and its bright spots are found in
// proportion. Compensated, it is in proportion to what that luminance has above the mean over the sphere
// (Karlik et al. 2019).
#include "render/environment_table.hpp"

#include "base/error.hpp"
#include "render/alias_table.hpp"
#include "render/luminance.hpp"
#include "shaders/shared/light.glsl.h"

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

constexpr std::uint32_t UNITS = 65536;

// Nodes of a tree's level, each of which spans 8^level entries.
std::uint32_t level_nodes(std::uint32_t count, std::uint32_t level) {
    return ((count - 1) >> (3 * level)) + 1;
}

// Between the tops of two rows, all around, in sr: 2 pi (cos a - cos b), as a product that does not cancel.
double band_solid_angle(std::uint32_t height, std::uint32_t top, std::uint32_t bottom) {
    const double step = 0.5 * std::numbers::pi / height;
    return 4 * std::numbers::pi * std::sin((bottom + top) * step) * std::sin((bottom - top) * step);
}

// The cells of a map, and how much each of them sends, up to a common factor.
struct Cells {
    std::uint32_t shift = 0;
    std::uint32_t columns = 0;
    std::uint32_t rows = 0;
    std::vector<double> powers; // columns * rows

    // Where that row or column begins, in texels of `size`.
    std::uint32_t edge(std::uint32_t cell, std::uint32_t size) const { return std::min(cell << shift, size); }
};

Cells measure_cells(const Environment& environment) {
    const std::size_t width = environment.width;
    const std::uint32_t height = environment.height;
    Cells cells;
    const auto bits =
        static_cast<std::uint32_t>(std::bit_width(std::max({environment.width, height, 2u}) - 1u));
    cells.shift = bits - std::min(bits, std::uint32_t{shared::ENVIRONMENT_CELL_BITS});
    cells.columns = ((environment.width - 1) >> cells.shift) + 1;
    cells.rows = ((height - 1) >> cells.shift) + 1;
    cells.powers.resize(std::size_t{cells.columns} * cells.rows);
    const std::vector<double> smooth = smoothed_rows(environment);
    tbb::parallel_for(std::uint32_t{0}, cells.rows, [&](std::uint32_t row) {
        double* out = &cells.powers[std::size_t{row} * cells.columns];
        for (std::uint32_t y = row << cells.shift; y < std::min((row + 1) << cells.shift, height); ++y) {
            const double* above = &smooth[(y > 0 ? y - 1 : 0) * width];
            const double* here = &smooth[y * width];
            const double* below = &smooth[std::min(y + 1, height - 1) * width];
            const double solid_angle = band_solid_angle(height, y, y + 1);
            for (std::size_t x = 0; x < width; ++x)
                out[x >> cells.shift] += solid_angle * (0.75 * here[x] + 0.125 * (above[x] + below[x]));
        }
    });
    return cells;
}

// Takes the mean over the sphere from every cell, as far as it has so much, and gives the share of all light
// that is left. What floats cannot tell from the mean is the mean.
double compensate(const Environment& environment, Cells& cells) {
    constexpr double ROUNDING = 0x1p-24;
    double total = 0;
    for (const double power : cells.powers) total += power;
    const double mean = total / (4 * std::numbers::pi);
    const std::uint32_t width = environment.width;
    const std::uint32_t height = environment.height;
    double left = 0;
    for (std::uint32_t row = 0; row < cells.rows; ++row) {
        const double band = band_solid_angle(height, cells.edge(row, height), cells.edge(row + 1, height));
        for (std::uint32_t column = 0; column < cells.columns; ++column) {
            const std::uint32_t texels = cells.edge(column + 1, width) - cells.edge(column, width);
            const double usual = mean * band * texels / width;
            double& power = cells.powers[std::size_t{row} * cells.columns + column];
            power = power > usual * (1 + ROUNDING) ? power - usual : 0;
            left += power;
        }
    }
    return total > 0 ? left / total : 0;
}

} // namespace

std::vector<std::uint32_t> environment_masses(std::span<const double> weights) {
    std::vector<std::uint32_t> masses = apportion(weights, UNITS - 1);
    const auto last =
        std::find_if(masses.rbegin(), masses.rend(), [](std::uint32_t mass) { return mass > 0; });
    if (last != masses.rend()) ++*last;
    return masses;
}

void append_search_trees(std::vector<glm::uvec4>& words, std::span<const std::uint32_t> masses,
                         std::uint32_t rows, std::uint32_t count) {
    const auto levels = static_cast<std::uint32_t>((std::bit_width(std::max(count, 2u) - 1u) - 1) / 3 + 1);
    for (std::uint32_t level = levels; level > 0; --level) {
        const std::uint32_t nodes = level_nodes(count, level);
        const std::uint32_t shift = 3 * (level - 1);
        const std::size_t first = words.size();
        words.resize(first + std::size_t{rows} * nodes);
        tbb::parallel_for(std::uint32_t{0}, rows, [&](std::uint32_t row) {
            const std::uint32_t* mass = masses.data() + std::size_t{row} * count;
            glm::uvec4* out = words.data() + first + std::size_t{row} * nodes;
            std::uint32_t sum = 0;
            std::uint64_t entry = 0;
            for (std::uint32_t child = 0; child < 8 * nodes; ++child) {
                for (; entry < std::min<std::uint64_t>(std::uint64_t{child} << shift, count); ++entry)
                    sum += mass[entry];
                out[child / 8][static_cast<int>(child % 8 / 2)] |= std::min(sum, UNITS - 1)
                                                                   << (child % 2 * 16);
            }
        });
    }
}

EnvironmentTable build_environment_table(const Environment& environment, EnvironmentDensity density_of) {
    EnvironmentTable table;
    if (environment.radiance.empty()) return table;
    if (std::max(environment.width, environment.height) > 65536)
        throw Error("environment '" + environment.name + "': more than 65536 texels across (scale it down)");
    Cells cells = measure_cells(environment);
    table.width = environment.width;
    table.height = environment.height;
    table.cell_shift = cells.shift;
    if (density_of == EnvironmentDensity::compensated) table.share = compensate(environment, cells);

    std::vector<double> row_powers(cells.rows);
    std::vector<std::uint32_t> columns(cells.powers.size());
    tbb::parallel_for(std::uint32_t{0}, cells.rows, [&](std::uint32_t row) {
        const std::span powers(&cells.powers[std::size_t{row} * cells.columns], cells.columns);
        for (const double power : powers) row_powers[row] += power;
        const std::vector<std::uint32_t> masses = environment_masses(powers);
        std::copy(masses.begin(), masses.end(), columns.begin() + std::ptrdiff_t{row} * cells.columns);
    });
    std::vector<std::uint32_t> rows = environment_masses(row_powers);

    table.words.resize(environment.radiance.size());
    tbb::parallel_for(std::uint32_t{0}, table.height, [&](std::uint32_t y) {
        const std::uint32_t row = y >> cells.shift;
        const double band =
            band_solid_angle(table.height, cells.edge(row, table.height), cells.edge(row + 1, table.height));
        for (std::uint32_t x = 0; x < table.width; ++x) {
            const std::uint32_t column = x >> cells.shift;
            const std::uint32_t cell_width =
                cells.edge(column + 1, table.width) - cells.edge(column, table.width);
            const double units = 1.0 * rows[row] * columns[std::size_t{row} * cells.columns + column];
            const auto density =
                static_cast<float>(units / (1.0 * UNITS * UNITS) / (band * cell_width / table.width));
            const std::size_t texel = std::size_t{y} * table.width + x;
            table.words[texel] =
                std::bit_cast<glm::uvec4>(glm::vec4(clean(environment.radiance[texel]), density));
        }
    });
    // Inversion has to end somewhere even then: in the first cell, whose density stays 0.
    if (std::all_of(rows.begin(), rows.end(), [](std::uint32_t mass) { return mass == 0; }))
        rows[0] = columns[0] = UNITS;
    append_search_trees(table.words, rows, 1, cells.rows);
    append_search_trees(table.words, columns, cells.rows, cells.columns);
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
        total += row * band_solid_angle(environment.height, y, y + 1) / double(environment.width);
    }
    return scale * total / (4 * std::numbers::pi);
}

} // namespace ajar
