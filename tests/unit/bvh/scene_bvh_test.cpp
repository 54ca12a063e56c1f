// Hierarchies of several meshes in one table, and the one over their placements.
#include "kernels/trace/soups.hpp"
#include "unit/bvh/hierarchy.hpp"

#include <algorithm>
#include <gtest/gtest.h>

namespace ajar::test {
namespace {

using Triangles = std::vector<bvh::Triangle>;

bvh::Placement placement(std::uint32_t mesh, const glm::mat3& linear, const glm::vec3& move) {
    bvh::Placement placed;
    placed.mesh = mesh;
    for (int row = 0; row < 3; ++row)
        placed.to_world[row] = glm::vec4(linear[0][row], linear[1][row], linear[2][row], move[row]);
    return placed;
}

Bounds placed_bounds(const Triangles& triangles, const bvh::Placement& placed) {
    Bounds bounds;
    for (const bvh::Triangle& triangle : triangles) {
        for (const glm::vec3& vertex : triangle.vertices) {
            const glm::dvec4 p(vertex, 1);
            bounds.include({glm::dot(glm::dvec4(placed.to_world[0]), p),
                            glm::dot(glm::dvec4(placed.to_world[1]), p),
                            glm::dot(glm::dvec4(placed.to_world[2]), p)});
        }
    }
    return bounds;
}

// Mirrored, flattened, sheared, turned, huge and tiny; none of them rigid.
std::vector<bvh::Placement> wild_placements(std::uint32_t count, std::uint32_t meshes, std::uint32_t seed) {
    Random random(seed);
    std::vector<bvh::Placement> placements;
    for (std::uint32_t i = 0; i < count; ++i) {
        glm::mat3 linear(random_point(random), random_point(random), random_point(random));
        linear *= std::pow(10.0f, uniform(random, -3, 3));
        if (i % 4 == 0) linear = glm::mat3(-1, 0, 0, 0, 1, 0, 0, 0, 1);
        if (i % 4 == 1) linear[int(random() % 3)] *= 1e-4f;
        if (i % 8 == 2) linear[1] = glm::vec3(0); // flat: nothing to hit, and still in its box
        placements.push_back(placement(1 + i % (meshes - 1), linear, random_point(random, 1000)));
    }
    return placements;
}

struct Meshes {
    std::vector<Triangles> triangles;
    std::vector<std::span<const bvh::Triangle>> spans() const { return {triangles.begin(), triangles.end()}; }
};

// The hierarchy of mesh m within the shared tables, checked; its depth.
std::uint32_t expect_sound_mesh(const bvh::SceneBvh& scene, const Meshes& meshes, std::size_t m) {
    const bvh::MeshRange& range = scene.meshes[m];
    EXPECT_EQ(range.triangle_count, meshes.triangles[m].size());
    const auto begin = scene.order.begin() + range.first_triangle;
    std::vector<std::uint32_t> sorted(begin, begin + range.triangle_count);
    std::sort(sorted.begin(), sorted.end());
    for (std::uint32_t i = 0; i < sorted.size(); ++i) EXPECT_EQ(sorted[i], i) << "mesh " << m;
    const Walk seen =
        walk(scene.nodes, range.root, range.first_triangle, range.triangle_count,
             [&](std::uint32_t item) { return bounds_of(meshes.triangles[m][scene.order[item]]); });
    EXPECT_EQ(seen.fault, "") << "mesh " << m;
    return seen.depth;
}

// Both levels, checked.
void expect_sound(const Meshes& meshes, const std::vector<bvh::Placement>& placements) {
    const auto spans = meshes.spans();
    const bvh::SceneBvh scene = bvh::build_scene_bvh(spans, placements);
    ASSERT_EQ(scene.meshes.size(), meshes.triangles.size());
    std::uint32_t depth = 0;
    for (std::size_t m = 0; m < scene.meshes.size(); ++m)
        depth = std::max(depth, expect_sound_mesh(scene, meshes, m));
    if (placements.empty()) {
        EXPECT_EQ(scene.root, scene.meshes[0].root);
        EXPECT_EQ(scene.stats.depth, depth);
        return;
    }
    ASSERT_EQ(scene.placement_order.size(), placements.size());
    const auto count = std::uint32_t(placements.size());
    const Walk top = walk(scene.nodes, scene.root, 1, count, [&](std::uint32_t instance) {
        const bvh::Placement& placed = placements[scene.placement_order[instance - 1]];
        return placed_bounds(meshes.triangles[placed.mesh], placed);
    });
    EXPECT_EQ(top.fault, "");
    EXPECT_EQ(top.largest_leaf, 1u);
    EXPECT_EQ(scene.stats.depth, depth + top.depth);
    std::vector<std::uint32_t> sorted = scene.placement_order;
    std::sort(sorted.begin(), sorted.end());
    for (std::uint32_t i = 0; i < count; ++i) EXPECT_EQ(sorted[i], i);
}

TEST(BuildSceneBvh, HoldsEveryMeshAndItsPlacements) {
    const Meshes meshes{{random_soup(100, 1), random_soup(1, 2), random_soup(3000, 3), random_soup(9, 4)}};
    for (const std::uint32_t count : {1u, 2u, 9u, 500u}) {
        SCOPED_TRACE(count);
        expect_sound(meshes, wild_placements(count, 4, count));
    }
}

TEST(BuildSceneBvh, WithoutPlacementsIsTheWorldAlone) { expect_sound({{random_soup(50, 5)}}, {}); }

TEST(BuildSceneBvh, TakesAnEmptyWorld) {
    expect_sound({{{}, random_soup(20, 6)}}, wild_placements(5, 2, 7));
    expect_sound({{{}}}, {});
}

TEST(BuildSceneBvh, TakesAMeshWithoutTriangles) {
    const Meshes meshes{{random_soup(4, 8), {}, random_soup(20, 9)}};
    std::vector<bvh::Placement> placements = wild_placements(12, 3, 10); // half of them place nothing
    expect_sound(meshes, placements);
}

TEST(BuildSceneBvh, HoldsPlacementsWhereFloatsAreCoarse) {
    std::vector<bvh::Placement> placements;
    for (int i = 0; i < 40; ++i)
        placements.push_back(placement(1, glm::mat3(0.3f), glm::vec3(1e6f + 0.1f * float(i), -3e6f, 1e4f)));
    expect_sound({{{}, random_soup(30, 12)}}, placements);
}

TEST(BuildSceneBvh, HoldsThousandsOfEqualPlacements) {
    const bvh::Placement placed = placement(1, glm::mat3(2), glm::vec3(1, 2, 3));
    expect_sound({{{}, random_soup(5, 11)}}, std::vector<bvh::Placement>(3000, placed));
}

} // namespace
} // namespace ajar::test
