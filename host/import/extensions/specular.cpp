// KHR_materials_specular: strength and tint of the dielectric's specular reflection. Its textures are not
// read.
#include "import/extensions/materials.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace ajar::gltf {

void read_specular(const MaterialInput& input, Material& material) {
    material.specular = std::clamp(input.extension.number("specularFactor", 1), 0.0f, 1.0f);
    material.specular_color =
        glm::max(input.extension.vector<3>("specularColorFactor", glm::vec3(1)), glm::vec3(0));
    if (input.extension.has("specularTexture") || input.extension.has("specularColorTexture"))
        input.document.warn(
            fmt::format("material '{}': the textures of KHR_materials_specular are ignored", material.name));
}

} // namespace ajar::gltf
