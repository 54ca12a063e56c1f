// A content hash of a Scene, field by field: padding, memory layout and file names do not enter.
#pragma once

#include "scene/scene.hpp"

#include <string>

namespace ajar {

// Thirty-two lower-case hexadecimal digits.
std::string scene_hash(const Scene& scene);

} // namespace ajar
