// KHR_texture_transform: an affine map of the texture coordinates, and a texCoord of its own.
#pragma once

#include "import/json.hpp"
#include "scene/scene.hpp"

namespace ajar::gltf {

// Sets the rows of `use`, and its uv_set where the extension overrides it. `texture_info` may lack the
// extension.
void read_texture_transform(const JsonObject& texture_info, TextureUse& use);

} // namespace ajar::gltf
