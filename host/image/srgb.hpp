// The sRGB transfer curve (IEC 61966-2-1), piecewise as the standard has it.
#pragma once

#include <cmath>
#include <glm/glm.hpp>

namespace ajar {

// Display-linear [0, 1] to encoded [0, 1].
inline float srgb_encode(float linear) {
    return linear <= 0.0031308f ? 12.92f * linear : 1.055f * std::pow(linear, 1 / 2.4f) - 0.055f;
}

inline float srgb_decode(float encoded) {
    return encoded <= 0.04045f ? encoded / 12.92f : std::pow((encoded + 0.055f) / 1.055f, 2.4f);
}

inline glm::vec3 srgb_encode(const glm::vec3& c) {
    return {srgb_encode(c.x), srgb_encode(c.y), srgb_encode(c.z)};
}
inline glm::vec3 srgb_decode(const glm::vec3& c) {
    return {srgb_decode(c.x), srgb_decode(c.y), srgb_decode(c.z)};
}

} // namespace ajar
