// Whether a scene that was written and read again is the one it was.
#pragma once

#include "scene/scene.hpp"

namespace ajar::test {

// Written by glb_bytes and imported. Throws what these throw.
Scene round_trip(const Scene& scene);

// Geometry, materials and texels to the bit; transforms, which pass through quaternions, within `tolerance`
// of their size.
void expect_same(const Scene& got, const Scene& wanted, float tolerance = 1e-6f);

} // namespace ajar::test
