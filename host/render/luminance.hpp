// Relative luminance of linear Rec. 709, by which importance is measured.
#pragma once

#include <glm/glm.hpp>

namespace ajar {

inline double luminance(const glm::dvec3& rgb) { return 0.2126 * rgb.x + 0.7152 * rgb.y + 0.0722 * rgb.z; }

} // namespace ajar
