// Which triangles, and which meshes as spheres, are lights.
#pragma once

#include "render/geometry_table.hpp"
#include "render/light_table.hpp"

#include <vector>

namespace ajar {

// The instances that emit as spheres: the first MAX_SOFT_LIGHTS that are marked so.
std::vector<EmissiveSphere> collect_emissive_spheres(const Scene& scene);

// Every other baked triangle that has area and emits anywhere, in leaf order.
std::vector<EmissiveTriangle> collect_emissive_triangles(const Scene& scene, const GeometryTable& geometry,
                                                         std::span<const EmissiveSphere> spheres);

} // namespace ajar
