// Tangents for normal maps, as MikkTSpace defines them (Mikkelsen, "Simulation of Wrinkled Surfaces
// Revisited", 2008, section 2.3), which is what glTF 2.0, section 3.7.2.1, names as the default.
#pragma once

#include "import/primitives.hpp"
#include "scene/scene.hpp"

namespace ajar::gltf {

// Fills primitive.tangents from the (transformed) texture coordinates of the normal map. A vertex whose
// triangles disagree is split. Needs unit normals and finite texture coordinates.
void make_tangents(const TextureUse& normal_map, Primitive& primitive);

// Makes a file's own tangents unit vectors with a handedness of 1 or -1.
void repair_tangents(Primitive& primitive);

// Some unit vector at right angles to the unit vector n.
glm::vec3 perpendicular(const glm::vec3& n);

} // namespace ajar::gltf
