// KHR_materials_unlit: the base colour as it is, without lighting.
#include "import/extensions/materials.hpp"

namespace ajar::gltf {

void read_unlit(const MaterialInput&, Material& material) { material.unlit = true; }

} // namespace ajar::gltf
