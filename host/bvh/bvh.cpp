// The three steps of a build, for triangles and for placed meshes.
#include "bvh/bvh.hpp"

#include "base/clock.hpp"
#include "base/error.hpp"
#include "bvh/encode.hpp"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

namespace ajar::bvh {
namespace {

constexpr std::size_t MAX_ITEMS = std::size_t(1) << 31;
constexpr float INSTANCE_COST = 8; // in node visits: a transform and a hierarchy of its own

Bvh build_over_boxes(std::span<const Box> boxes, const BuildOptions& options) {
    Bvh bvh;
    if (boxes.empty()) {
        bvh.nodes.resize(1);
        bvh.stats.depth = 1;
        return bvh;
    }
    for (const SplitRule rule : {SplitRule::surface_area, SplitRule::median}) {
        const BinaryTree tree = build_binary_tree(boxes, rule);
        const Collapse collapse(tree, options);
        encode(tree, collapse, bvh);
        bvh.stats.sah_cost = collapse.sah_cost();
        if (bvh.stats.depth <= shared::BVH_MAX_DEPTH) break;
    }
    if (bvh.nodes.size() > shared::BVH_MAX_NODES)
        throw Error(
            fmt::format("scene: hierarchy: {} nodes, but at most {} can be addressed (use fewer triangles)",
                        bvh.nodes.size(), shared::BVH_MAX_NODES));
    return bvh;
}

std::vector<Box> triangle_boxes(std::span<const Triangle> triangles) {
    std::vector<Box> boxes(triangles.size());
    tbb::parallel_for(std::size_t(0), triangles.size(), [&](std::size_t i) {
        for (const glm::vec3& vertex : triangles[i].vertices) boxes[i].include(vertex);
    });
    return boxes;
}

// World-space box of a placed hierarchy: the corners of its root's slots, widened by the rounding of the
// transform.
Box place(const shared::BvhNode& root, const glm::vec4 (&to_world)[3]) {
    constexpr double ROUNDING = 1.0 / (1 << 20);
    Box placed;
    if (root.inner_orders == 0 && root.leaves == 0) // nothing in it: any place will do
        placed.include(glm::vec3(to_world[0][3], to_world[1][3], to_world[2][3]));
    for (std::uint32_t slot = 0; slot < shared::BVH_WIDTH; ++slot) {
        if ((root.inner_orders >> slot & 1) == 0 && (root.leaves >> (shared::BVH_MAX_LEAF * slot) & 1) == 0)
            continue;
        const Box box = decode_slot(root, slot);
        for (int corner = 0; corner < 8; ++corner) {
            glm::vec3 lower, upper;
            for (int row = 0; row < 3; ++row) {
                double sum = to_world[row][3];
                double magnitude = std::abs(sum);
                for (int axis = 0; axis < 3; ++axis) {
                    const double x = corner >> axis & 1 ? box.upper[axis] : box.lower[axis];
                    sum += x * to_world[row][axis];
                    magnitude += std::abs(x * to_world[row][axis]);
                }
                lower[row] = float(sum - magnitude * ROUNDING);
                upper[row] = float(sum + magnitude * ROUNDING);
            }
            placed.include(lower);
            placed.include(upper);
        }
    }
    return placed;
}

// Appends a hierarchy's nodes with its indices made global.
std::uint32_t append(SceneBvh& scene, const Bvh& bvh, std::uint32_t first_triangle) {
    const std::size_t base = scene.nodes.size();
    if (base + bvh.nodes.size() > shared::BVH_MAX_NODES)
        throw Error(
            fmt::format("scene: hierarchy: more than {} nodes (use fewer triangles)", shared::BVH_MAX_NODES));
    for (shared::BvhNode node : bvh.nodes) {
        node.child_base += std::uint32_t(base) << 8;
        node.triangle_base += first_triangle;
        scene.nodes.push_back(node);
    }
    return std::uint32_t(base);
}

} // namespace

shared::TriangleRecord make_record(const Triangle& triangle, std::uint32_t flags, std::uint32_t material,
                                   std::uint32_t object) {
    const glm::dvec3 first = triangle.vertices[0];
    const glm::dvec3 twice_area =
        glm::cross(glm::dvec3(triangle.vertices[1]) - first, glm::dvec3(triangle.vertices[2]) - first);
    // Vertices on a line: rounding could make a hit of it, so it becomes a point, which no ray meets.
    const bool degenerate = twice_area == glm::dvec3(0);
    const glm::vec3 v[3] = {triangle.vertices[0], triangle.vertices[degenerate ? 0 : 1],
                            triangle.vertices[degenerate ? 0 : 2]};
    return {{v[0].x, v[1].x, v[2].x}, flags, {v[0].y, v[1].y, v[2].y}, material,
            {v[0].z, v[1].z, v[2].z}, object};
}

Bvh build_bvh(std::span<const Triangle> triangles, const BuildOptions& options) {
    const Clock::time_point start = Clock::now();
    if (triangles.size() > MAX_ITEMS)
        throw Error(fmt::format("scene: hierarchy: {} triangles, but at most {} are possible (use fewer)",
                                triangles.size(), MAX_ITEMS));
    Bvh bvh = build_over_boxes(triangle_boxes(triangles), options);
    bvh.stats.seconds = seconds_since(start);
    return bvh;
}

SceneBvh build_scene_bvh(std::span<const std::span<const Triangle>> meshes,
                         std::span<const Placement> placements, const BuildOptions& options) {
    const Clock::time_point start = Clock::now();
    SceneBvh scene;
    std::uint32_t mesh_depth = 0;
    for (std::size_t m = 0; m < meshes.size(); ++m) {
        const Bvh bvh = build_bvh(meshes[m], options);
        const auto first = std::uint32_t(scene.order.size());
        scene.meshes.push_back({append(scene, bvh, first), first, std::uint32_t(bvh.order.size())});
        scene.order.insert(scene.order.end(), bvh.order.begin(), bvh.order.end());
        mesh_depth = std::max(mesh_depth, bvh.stats.depth);
        if (m == 0) scene.stats.sah_cost = bvh.stats.sah_cost;
    }
    scene.stats.depth = mesh_depth;
    if (!placements.empty()) {
        std::vector<Box> boxes;
        for (const Placement& placement : placements)
            boxes.push_back(place(scene.nodes[scene.meshes[placement.mesh].root], placement.to_world));
        BuildOptions single = options;
        single.max_leaf_triangles = 1;
        single.triangle_cost = INSTANCE_COST;
        const Bvh top = build_over_boxes(boxes, single);
        scene.root = append(scene, top, 1);
        scene.placement_order = top.order;
        scene.stats.depth += top.stats.depth;
    }
    scene.stats.seconds = seconds_since(start);
    return scene;
}

std::uint32_t stack_registers(const SceneBvh& bvh) {
    if (!bvh.placement_order.empty()) return 0;
    // One group for each level between the root and the last inner node.
    const std::uint32_t waiting = std::max(bvh.stats.depth, 3u) - 2;
    const std::uint32_t rounded = (waiting + 3) / 4 * 4;
    return rounded <= shared::BVH_REGISTERS ? rounded : 0;
}

bool suits_shadow_packets(const SceneBvh& bvh) {
    constexpr std::size_t FEW_TRIANGLES = 2000;
    return bvh.order.size() <= FEW_TRIANGLES;
}

} // namespace ajar::bvh
