// KHR_lights_punctual: point, spot and directional lights; of their extras {"radius": metres} makes a
// sphere of a point or spot light, {"angular_diameter_degrees": x} a sun of a directional one.
#pragma once

#include "import/nodes.hpp"

namespace ajar::gltf {

// Appends the lights of the chosen scene, in world space.
void add_punctual_lights(Document& document, const Nodes& nodes, Scene& scene);

} // namespace ajar::gltf
