// The environment map as the device reads it: radiance with its sampling density, then the trees by which
// shaders/lights/environment.glsl inverts the cumulative distributions. After Pharr et al. 2023, section
// 12.5.2.
#pragma once

#include "scene/scene.hpp"

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace ajar {

// What the density of the cells is made of.
enum class EnvironmentDensity : std::uint8_t {
    radiance,    // positive wherever the lookup is: light sampling alone misses nothing
    compensated, // by how much radiance is above its mean: for MIS, where BSDF sampling finds the rest
};

// words: width * height texels (r, g, b, density by solid angle in 1/sr), as floats, rows top to bottom; then
// the tree over rows of cells; then one tree per such row over its columns. A cell is 2^cell_shift texels
// wide and high, less at the right and lower border. Its density is that of all its texels.
struct EnvironmentTable {
    std::uint32_t width = 0; // 0: no map
    std::uint32_t height = 0;
    std::uint32_t cell_shift = 0;
    double share = 1;              // of the map's light that the density is made of; luminance
    std::vector<glm::uvec4> words; // BIND_ENVIRONMENT
};

// Negative and not-a-number texels count as black. A density of nothing, such as a constant map's when it is
// compensated, is 0 throughout. Throws Error for maps of more than 65536 texels across.
EnvironmentTable build_environment_table(const Environment& environment,
                                         EnvironmentDensity density = EnvironmentDensity::radiance);

// Mean over the sphere, scale included; the scale alone where there is no map. W/(m^2 sr)
glm::dvec3 mean_radiance(const Environment& environment);

// Integers that sum to 2^16, in proportion to the weights like apportion(); the last positive one is at least
// 2, so that none but the end lies beyond 65534. All 0 when no weight is positive.
std::vector<std::uint32_t> environment_masses(std::span<const double> weights);

// Appends `rows` 8-ary trees over `count` masses each (row after row in `masses`), level by level from the
// root. A node is eight 16-bit numbers: where its children begin, i.e. the sum of the masses before; 65535
// for the end.
void append_search_trees(std::vector<glm::uvec4>& words, std::span<const std::uint32_t> masses,
                         std::uint32_t rows, std::uint32_t count);

} // namespace ajar
