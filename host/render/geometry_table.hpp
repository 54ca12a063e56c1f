// Triangles, surfaces and instances as the device reads them: what is baked into the world and what stays
// instanced.
#pragma once

#include "bvh/bvh.hpp"
#include "render/surface_index.hpp"
#include "scene/scene.hpp"
#include "shaders/shared/geometry.glsl.h"

#include <cstdint>
#include <vector>

namespace ajar {

struct GeometryOptions {
    bool cull_backfaces = false;
    bool extended_surfaces = false; // store second texture coordinates, tangents and vertex colours
    // Meshes used more than once are baked as well while all triangles stay below this: one level is faster
    // to trace.
    std::uint64_t bake_below_triangles = 1u << 20;
};

struct GeometryTable {
    bvh::SceneBvh bvh;
    std::vector<shared::TriangleRecord> triangles; // leaf order
    std::vector<TriangleSource> sources;           // leaf order
    std::vector<std::uint32_t> surfaces;           // SurfaceRecord, SurfaceExtension: words, leaf order
    std::uint32_t surface_words = 0;               // per triangle
    std::vector<shared::InstanceRecord> instances; // 0: the world
    std::uint32_t world_triangles = 0;             // leaf order begins with them
    std::uint64_t unsure_triangles = 0; // that rays have to look at (TRIANGLE_ALPHA), in all instances
};

GeometryTable build_geometry_table(const Scene& scene, const GeometryOptions& options);

// Whether any mesh has what a SurfaceExtension holds and a material could use.
bool wants_extended_surfaces(const Scene& scene, bool uses_uv1);

} // namespace ajar
