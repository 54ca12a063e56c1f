// Normals as the scene wants them: unit vectors for every vertex.
#pragma once

#include "import/primitives.hpp"

namespace ajar::gltf {

// For a primitive without normals: every triangle gets three vertices of its own with its face's normal, as
// glTF 2.0, section 3.7.2.1, asks.
void make_flat_normals(Primitive& primitive);

// Normalises. A normal of zero or non-finite length becomes the area-weighted mean of the faces around it.
void repair_normals(Primitive& primitive);

} // namespace ajar::gltf
