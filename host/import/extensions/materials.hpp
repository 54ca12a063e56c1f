// The readers of the material extensions, one file each. Each is called for a material that has the
// extension.
#pragma once

#include "import/materials.hpp"

namespace ajar::gltf {

void read_emissive_strength(const MaterialInput& input, Material& material);
void read_ior(const MaterialInput& input, Material& material);
void read_specular(const MaterialInput& input, Material& material);
void read_specular_glossiness(const MaterialInput& input, Material& material);
void read_unlit(const MaterialInput& input, Material& material);

} // namespace ajar::gltf
