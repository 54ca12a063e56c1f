// The scene's surfaces as patches: every triangle in world space, divided by bisection of longest edges
// (Rivara 1984, "Algorithms for refining triangular grids suitable for adaptive and multigrid techniques").
// The mesh is conforming: where triangles share an edge they are divided alike, so that values at vertices
// join without cracks. A patch has two sides, see shared/patch.glsl.h.
#pragma once

#include "radiosity/settings.hpp"
#include "render/surface_index.hpp"
#include "scene/scene.hpp"
#include "shaders/shared/patch.glsl.h"

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace ajar {

struct Patch {
    std::uint32_t source = 0;       // PatchMesh::sources: the scene triangle that it is part of
    std::uint32_t vertices[3] = {}; // PatchMesh::positions, counter-clockwise as the front sees them
    glm::vec2 corners[3] = {}; // the same in the source's barycentrics (u: of its 2nd vertex, v: of its 3rd)
    float area = 0;            // m^2: the source's times a power of 1/2
    glm::vec3 normal{0};       // geometric, unit, to the front
};

// A scene triangle that has area. Its vertices are ordered as in PatchMesh::mesh_triangle().
struct PatchSource {
    std::uint32_t instance = 0; // Scene::instances
    std::uint32_t triangle = 0; // of its mesh
    std::uint32_t material = 0; // Scene::materials
    std::uint32_t root = 0;     // PatchMesh::nodes: its own index in PatchMesh::sources
};

// A place within a patch, in its barycentrics (of its 2nd and 3rd vertex).
struct PatchPoint {
    std::uint32_t patch = 0;
    float u = 0;
    float v = 0;
};

struct PatchMesh {
    std::vector<glm::vec3> positions; // world, metres; no two are equal
    std::vector<Patch> patches;       // source by source, neighbours near each other
    std::vector<PatchSource> sources; // in the order of instances and triangles
    std::vector<shared::PatchNode> nodes;

    // The longest edge of the whole mesh first. Throws Error above MAX_PATCHES.
    static PatchMesh subdivide(const Scene& scene, const PatchOptions& options);

    // Bisects every patch whose entry is not 0, and what must follow to stay conforming. Patches are numbered
    // anew; returns, for each, the number that it or the patch it was part of had before.
    std::vector<std::uint32_t> refine(std::span<const std::uint8_t> marked);

    // As radiosity/patch_lookup.glsl finds it.
    PatchPoint find(std::uint32_t source, float u, float v) const;

    // The sources, as PatchTable wants them.
    std::vector<TriangleSource> triangles() const;

    // The source's vertices in its mesh, counter-clockwise in the world as its front sees them: a mirrored
    // instance exchanges the 2nd and 3rd, as on the device.
    static glm::uvec3 mesh_triangle(const Scene& scene, const PatchSource& source);
};

} // namespace ajar
