// KHR_materials_emissive_strength: a factor for emission beyond 1.
#include "import/extensions/materials.hpp"

namespace ajar::gltf {

void read_emissive_strength(const MaterialInput& input, Material& material) {
    const float strength = input.extension.number("emissiveStrength", 1);
    if (strength < 0) input.extension.fail("emissiveStrength", "must not be negative");
    material.emission *= strength;
}

} // namespace ajar::gltf
