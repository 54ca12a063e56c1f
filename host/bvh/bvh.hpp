// Bounding volume hierarchies: triangles in, wide quantised nodes and a triangle order out. Pure functions,
// no GPU. Binned SAH (Wald 2007) over a binary tree, collapsed to wide nodes by dynamic programming over SAH
// and quantised as in Ylitie, Karras and Laine 2017. The same input gives the same bytes whatever the number
// of threads.
#pragma once

#include "shaders/shared/bvh.glsl.h"

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace ajar::bvh {

// Vertices in metres, all finite. Degenerate triangles are fine: they are kept, and never hit.
struct Triangle {
    glm::vec3 vertices[3];
};

// A triangle as the kernels read it, and back.
shared::TriangleRecord make_record(const Triangle& triangle, std::uint32_t flags, std::uint32_t material,
                                   std::uint32_t object);
inline glm::vec3 record_vertex(const shared::TriangleRecord& record, int k) {
    return {record.x[k], record.y[k], record.z[k]};
}

// Costs in units of one node visit; they steer quality only.
struct BuildOptions {
    std::uint32_t max_leaf_triangles = 3; // 1 to 3
    float triangle_cost = 0.3f;
};

struct BuildStats {
    double sah_cost = 0;     // expected cost of a random line that hits the root's box, in node visits
    std::uint32_t depth = 0; // nodes on the longest way from root to leaf; at most BVH_MAX_DEPTH
    double seconds = 0;
};

// One hierarchy; node 0 is its root.
struct Bvh {
    std::vector<shared::BvhNode> nodes;
    std::vector<std::uint32_t> order; // order[k]: input index of the triangle at place k of the leaf order
    BuildStats stats;
};

// No triangle at all gives one node without children. Throws Error above 2^31 triangles.
Bvh build_bvh(std::span<const Triangle> triangles, const BuildOptions& options = {});

// A mesh placed in the world.
struct Placement {
    std::uint32_t mesh = 0;
    glm::vec4 to_world[3]; // rows of the 3 x 4 matrix
};

// Where a mesh's part of the shared tables lies.
struct MeshRange {
    std::uint32_t root = 0;           // node
    std::uint32_t first_triangle = 0; // in leaf order
    std::uint32_t triangle_count = 0;
};

// Hierarchies of several meshes in one table, and one over their placements. Indices in nodes are global.
struct SceneBvh {
    std::vector<shared::BvhNode> nodes;
    std::vector<std::uint32_t> order; // leaf order of all meshes, one after the other; indices within a mesh
    std::vector<MeshRange> meshes;
    std::uint32_t root = 0;                     // of mesh 0; with placements: of the hierarchy over them
    std::vector<std::uint32_t> placement_order; // InstanceRecord 1 + k is placement placement_order[k]
    BuildStats stats; // cost: mesh 0's; depth: of the deepest way through both levels
};

// Mesh 0 is the world (instance 0, may be empty), traced without a transform; `placements` put the others
// around it.
SceneBvh build_scene_bvh(std::span<const std::span<const Triangle>> meshes,
                         std::span<const Placement> placements, const BuildOptions& options = {});

// SPEC_STACK_REGISTERS: how many groups of nodes can wait at a time on the way through this hierarchy,
// rounded up so that few kernels are compiled; 0 where they are better in memory.
std::uint32_t stack_registers(const SceneBvh& bvh);

// Whether it is so small that shadow rays from neighbouring points meet mostly the same nodes, and are better
// traced together. Measured on lavapipe: 1.1 to 1.3 times faster with up to 1,300 triangles, slower from
// 4,000.
bool suits_shadow_packets(const SceneBvh& bvh);

} // namespace ajar::bvh
