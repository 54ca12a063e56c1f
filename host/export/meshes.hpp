// Meshes as glTF primitives.
#pragma once

#include "export/document.hpp"

#include <vector>

namespace ajar::gltf_out {

// Per mesh of the scene its index in the file, or NO_INDEX where it has no triangles or no instance.
std::vector<std::uint32_t> add_meshes(const Scene& scene, Document& document);

} // namespace ajar::gltf_out
