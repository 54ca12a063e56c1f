// KHR_materials_ior: the dielectric's index of refraction. 0 means a Fresnel term of 1, as the extension
// says.
#include "import/extensions/materials.hpp"

namespace ajar::gltf {

void read_ior(const MaterialInput& input, Material& material) {
    material.ior = input.extension.number("ior", 1.5f);
    if (material.ior != 0 && material.ior < 1) input.extension.fail("ior", "must be 0 or at least 1");
}

} // namespace ajar::gltf
