// Transforms as glTF nodes.
#pragma once

#include "export/document.hpp"

namespace ajar::gltf_out {

// Adds `node` where `to_world` puts it, by translation, rotation and scale. What shears, which one node must
// not do, becomes two: a stretch along the axes of a rotated child (singular value decomposition).
void place(Document& document, Json node, const glm::mat4& to_world);

} // namespace ajar::gltf_out
