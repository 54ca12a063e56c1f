// Which triangles are lights.
#pragma once

#include "render/geometry_table.hpp"
#include "render/light_table.hpp"

#include <vector>

namespace ajar {

// Every baked triangle that has area and emits anywhere, in leaf order.
std::vector<EmissiveTriangle> collect_emissive_triangles(const Scene& scene, const GeometryTable& geometry);

} // namespace ajar
