// KHR_materials_pbrSpecularGlossiness (archived): approximated by a dielectric of the diffuse colour.
#include "import/extensions/materials.hpp"

namespace ajar::gltf {

void read_specular_glossiness(const MaterialInput& input, Material& material) {
    if (input.material.has("pbrMetallicRoughness")) return; // the exporter made its own approximation
    material.base_color = input.extension.vector<4>("diffuseFactor", glm::vec4(1));
    material.base_color_texture = input.textures.use(input.extension.object("diffuseTexture"));
    material.metallic = 0;
    material.roughness = 1 - input.extension.number("glossinessFactor", 1);
}

} // namespace ajar::gltf
