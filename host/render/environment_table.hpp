// The environment map as the device reads it: radiance with its sampling density, then the trees by which
// shaders/lights/environment.glsl inverts the cumulative distributions. After Pharr et al. 2023, section
// 12.5.2.
#pragma once

#include "scene/scene.hpp"

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace ajar {

// words: width * height texels (r, g, b, density by solid angle in 1/sr), as floats, rows top to bottom; then
// the tree over rows; then one tree per row over its columns.
struct EnvironmentTable {
    std::uint32_t width = 0; // 0: no map
    std::uint32_t height = 0;
    std::vector<glm::uvec4> words; // BIND_ENVIRONMENT
};

// Negative and not-a-number texels count as black. Throws Error for maps of more than 65536 texels across.
EnvironmentTable build_environment_table(const Environment& environment);

// Mean over the sphere, scale included; the scale alone where there is no map. W/(m^2 sr)
glm::dvec3 mean_radiance(const Environment& environment);

// Solid angle of one texel of a row, in sr.
double environment_texel_solid_angle(std::uint32_t width, std::uint32_t height, std::uint32_t row);

// Appends `rows` trees over `count` masses each (row after row in `masses`), laid out level by level. A node
// holds where its four children begin: the sum of the masses before them; beyond the last entry, the total.
void append_search_trees(std::vector<glm::uvec4>& words, const std::vector<std::uint32_t>& masses,
                         std::uint32_t rows, std::uint32_t count);

} // namespace ajar
