// Unit vectors in 32 bits, the inverse of shaders/core/octahedral.glsl (Cigolle et al. 2014).
#pragma once

#include <cstdint>
#include <glm/glm.hpp>

namespace ajar {

// 2 x snorm16, x in the low half; a zero vector gives the code of +Z. Angular error below 6.5e-5 radians.
std::uint32_t octahedral_encode(const glm::vec3& n);

} // namespace ajar
