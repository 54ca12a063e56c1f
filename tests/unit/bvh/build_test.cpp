// A hierarchy over triangles keeps the promises of bvh.hpp and bvh.glsl.h, whatever the triangles.
#include "bvh/binary_tree.hpp"
#include "bvh/collapse.hpp"
#include "kernels/trace/soups.hpp"
#include "unit/bvh/hierarchy.hpp"

#include <cstring>
#include <gtest/gtest.h>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

namespace ajar::test {
namespace {

using Triangles = std::vector<bvh::Triangle>;

// Builds, checks everything that holds for all input, and returns what the walk saw.
Walk expect_sound(const Triangles& triangles, const bvh::BuildOptions& options = {}) {
    const bvh::Bvh hierarchy = bvh::build_bvh(triangles, options);
    Walk seen = walk(hierarchy, triangles);
    EXPECT_EQ(seen.fault, "");
    EXPECT_EQ(seen.depth, hierarchy.stats.depth);
    EXPECT_LE(seen.depth, shared::BVH_MAX_DEPTH);
    EXPECT_LE(seen.largest_leaf, options.max_leaf_triangles);
    return seen;
}

Triangles scaled(Triangles triangles, float scale) {
    for (bvh::Triangle& triangle : triangles)
        for (glm::vec3& vertex : triangle.vertices) vertex *= scale;
    return triangles;
}

bvh::Triangle triangle_at(const glm::vec3& place, float size) {
    return {{place, place + glm::vec3(size, 0, 0), place + glm::vec3(0, size, size)}};
}

// Few dense clumps, far apart and of unequal numbers: halving by number cuts through them.
Triangles clustered_soup(std::uint32_t count, std::uint32_t seed) {
    Random random(seed);
    std::vector<glm::vec3> clumps;
    for (int i = 0; i < 17; ++i) clumps.push_back(random_point(random, 100));
    Triangles triangles(count);
    for (bvh::Triangle& triangle : triangles) {
        const glm::vec3 clump = clumps[std::min(random() % 17, random() % 17)];
        const glm::vec3 center = clump + random_point(random);
        for (glm::vec3& vertex : triangle.vertices) vertex = center + random_point(random, 0.05f);
    }
    return triangles;
}

TEST(BuildBvh, HoldsEveryTriangleOnceInsideAllBoxesAboveIt) {
    for (const std::uint32_t count : {1u, 2u, 3u, 4u, 7u, 8u, 9u, 30u, 65u, 1000u, 20000u}) {
        SCOPED_TRACE(count);
        expect_sound(random_soup(count, count));
    }
}

TEST(BuildBvh, OfNothingIsOneNodeWithoutChildren) {
    const bvh::Bvh hierarchy = bvh::build_bvh({});
    ASSERT_EQ(hierarchy.nodes.size(), 1u);
    EXPECT_EQ(hierarchy.nodes[0].inner_orders, 0u);
    EXPECT_EQ(hierarchy.nodes[0].leaves, 0u);
    EXPECT_TRUE(hierarchy.order.empty());
    EXPECT_EQ(hierarchy.stats.depth, 1u);
}

TEST(BuildBvh, KeepsLeavesAsSmallAsAsked) {
    const Triangles triangles = random_soup(500, 3);
    for (std::uint32_t most = 1; most <= shared::BVH_MAX_LEAF; ++most) {
        bvh::BuildOptions options;
        options.max_leaf_triangles = most;
        options.triangle_cost = 0; // so that large leaves are worth it
        EXPECT_EQ(expect_sound(triangles, options).largest_leaf, most);
    }
}

TEST(BuildBvh, KeepsDegenerateTriangles) {
    Triangles triangles = random_soup(300, 4);
    for (std::size_t i = 0; i < triangles.size(); i += 3) {
        triangles[i].vertices[1] = triangles[i].vertices[0];                // a line
        for (glm::vec3& v : triangles[i + 1].vertices) v = glm::vec3(0.5f); // points, many of them the same
    }
    expect_sound(triangles);
    expect_sound(Triangles(100, triangle_at(glm::vec3(1, 2, 3), 0))); // the root's box is a point
    expect_sound(Triangles(1, triangle_at(glm::vec3(0), 0)));
}

TEST(BuildBvh, IsShallowWhereAllCentresCoincide) {
    const Walk same = expect_sound(Triangles(10000, triangle_at(glm::vec3(1, 2, 3), 1)));
    EXPECT_LE(same.depth, 8u); // 8^5 leaves hold them; no plane separates any
    Triangles nested;          // one centre, sizes of every magnitude
    for (int i = -60; i < 60; ++i) {
        const float size = std::ldexp(1.0f, i);
        nested.push_back({{glm::vec3(-size), glm::vec3(size), glm::vec3(size, -size, size)}});
    }
    expect_sound(nested);
}

TEST(BuildBvh, TakesHugeAndTinyCoordinates) {
    for (const float scale : {1e-40f, 1e-18f, 1e18f, 1e38f}) {
        SCOPED_TRACE(scale);
        expect_sound(scaled(random_soup(1000, 5), scale));
    }
}

TEST(BuildBvh, HoldsSmallTrianglesFarFromTheOrigin) {
    Triangles triangles = random_soup(1000, 6);
    for (bvh::Triangle& triangle : triangles)
        for (glm::vec3& vertex : triangle.vertices) vertex += glm::vec3(1e6f, -1e18f, 16777216.0f);
    expect_sound(triangles);
}

TEST(BuildBvh, StaysWithinItsDepthForRowsThatSahWouldPeel) {
    Triangles diagonal;
    for (int i = 0; i < 20000; ++i) diagonal.push_back(triangle_at(glm::vec3(float(i)), 1e-3f));
    expect_sound(diagonal);
    Triangles geometric; // each next one is as far out as all before it together
    for (int axis = 0; axis < 3; ++axis) {
        for (int i = -100; i < 100; ++i) {
            glm::vec3 place(0);
            place[axis] = std::ldexp(1.0f, i);
            geometric.push_back(triangle_at(place, 0.1f * place[axis]));
        }
    }
    expect_sound(geometric);
}

TEST(BuildBvh, ReportsItsCost) {
    const Triangles triangles = clustered_soup(5000, 7);
    bvh::BuildOptions options;
    options.triangle_cost = 0.7f;
    const Walk seen = walk(bvh::build_bvh(triangles, options), triangles);
    const double cost = (seen.node_area + 0.7 * seen.item_area) / seen.root_area;
    EXPECT_NEAR(bvh::build_bvh(triangles, options).stats.sah_cost, cost, 1e-4 * cost);
}

TEST(BuildBvh, CostsNoMoreThanHalvingByNumber) {
    for (const std::uint32_t count : {100u, 3000u, 50000u}) {
        const Triangles triangles = clustered_soup(count, count);
        std::vector<bvh::Box> boxes(count);
        for (std::uint32_t i = 0; i < count; ++i)
            for (const glm::vec3& vertex : triangles[i].vertices) boxes[i].include(vertex);
        const bvh::BinaryTree median = build_binary_tree(boxes, bvh::SplitRule::median);
        EXPECT_LE(bvh::build_bvh(triangles).stats.sah_cost, bvh::Collapse(median, {}).sah_cost()) << count;
    }
}

bvh::Bvh build_with(int threads, const Triangles& triangles) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, std::size_t(threads));
    tbb::task_arena arena(threads); // as many threads, even on fewer cores
    return arena.execute([&] { return bvh::build_bvh(triangles); });
}

TEST(BuildBvh, GivesTheSameBytesWithAnyNumberOfThreads) {
    // Large enough for every step to go parallel.
    for (const Triangles& triangles : {random_soup(150000, 8), clustered_soup(150000, 9),
                                       Triangles(70000, triangle_at(glm::vec3(0), 1))}) {
        const bvh::Bvh alone = build_with(1, triangles);
        for (const int threads : {1, 2, 2, 5}) {
            const bvh::Bvh other = build_with(threads, triangles);
            ASSERT_EQ(other.nodes.size(), alone.nodes.size()) << threads;
            EXPECT_EQ(std::memcmp(other.nodes.data(), alone.nodes.data(),
                                  alone.nodes.size() * sizeof(alone.nodes[0])),
                      0)
                << threads;
            EXPECT_EQ(other.order, alone.order) << threads;
            EXPECT_EQ(other.stats.depth, alone.stats.depth);
            EXPECT_EQ(other.stats.sah_cost, alone.stats.sah_cost);
        }
    }
}

} // namespace
} // namespace ajar::test
