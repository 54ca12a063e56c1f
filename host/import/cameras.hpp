// Cameras of the chosen scene (glTF 2.0, section 3.10).
#pragma once

#include "import/nodes.hpp"

namespace ajar::gltf {

// Appends the scene's cameras in the order of its nodes, or one that frames it where it has none.
void add_cameras(Document& document, const Nodes& nodes, Scene& scene);

} // namespace ajar::gltf
