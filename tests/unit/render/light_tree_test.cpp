// The light tree on the host: every light has its place, and every node bounds what is below it.
#include "render/light_tree.hpp"

#include "render/light_table.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <gtest/gtest.h>
#include <random>
#include <tbb/task_arena.h>

namespace ajar::test {
namespace {

using shared::LightTreeNode;

std::vector<LightBounds> random_lights(std::size_t count, std::uint32_t seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> unit(-1, 1);
    std::vector<LightBounds> lights;
    for (std::size_t i = 0; i < count; ++i) {
        EmissiveTriangle t;
        const glm::vec3 place = 10.0f * glm::vec3(unit(random), unit(random), unit(random));
        t.p0 = place;
        t.p1 = place + glm::vec3(unit(random), unit(random), unit(random));
        t.p2 = place + glm::vec3(unit(random), unit(random), unit(random));
        t.area = 0.5f * glm::length(glm::cross(t.p1 - t.p0, t.p2 - t.p0));
        t.emission = glm::vec3(std::exp(4 * unit(random)));
        t.two_sided = random() % 16 == 0;
        lights.push_back(light_bounds(t));
        if (random() % 8 != 0) continue;
        Light light;
        light.kind = random() % 2 == 0 ? LightKind::point : LightKind::spot;
        light.position = place;
        light.direction = lights.back().axis;
        lights.push_back(light_bounds(light));
    }
    return lights;
}

// Light and depth of every leaf, by walking down.
void visit(const LightTree& tree, std::uint32_t node, std::uint32_t depth, std::uint32_t trail,
           const std::function<void(std::uint32_t light, std::uint32_t depth, std::uint32_t trail)>& leaf) {
    const std::uint32_t child = tree.nodes[node].child;
    const std::uint32_t index = child & shared::LIGHT_TREE_INDEX;
    if ((child & shared::LIGHT_TREE_LEAF) != 0) return leaf(index, depth, trail);
    visit(tree, 2 * index, depth + 1, trail, leaf);
    visit(tree, 2 * index + 1, depth + 1, trail | 1u << depth, leaf);
}

void expect_every_light_once(const LightTree& tree, std::span<const LightBounds> lights) {
    std::vector<int> seen(lights.size(), 0);
    visit(tree, 0, 0, 0, [&](std::uint32_t light, std::uint32_t depth, std::uint32_t trail) {
        ASSERT_LT(light, lights.size());
        ++seen[light];
        EXPECT_EQ(tree.trails[light], trail);
        EXPECT_LE(depth, tree.depth);
    });
    for (std::size_t i = 0; i < lights.size(); ++i)
        EXPECT_EQ(seen[i], lights[i].intensity > 0 ? 1 : 0) << "light " << i;
    EXPECT_LE(tree.depth, shared::LIGHT_TREE_MAX_DEPTH);
}

TEST(LightTree, HoldsEveryLightWithIntensityOnceAtTheEndOfItsTrail) {
    for (const std::size_t count : {1u, 2u, 3u, 7u, 100u, 5000u}) {
        const std::vector<LightBounds> lights = random_lights(count, static_cast<std::uint32_t>(count));
        expect_every_light_once(build_light_tree(lights), lights);
    }
}

TEST(LightTree, LeavesOutLightsWithoutIntensity) {
    std::vector<LightBounds> lights = random_lights(20, 3);
    lights[4].intensity = 0;
    lights[9].intensity = 0;
    const LightTree tree = build_light_tree(lights);
    EXPECT_EQ(tree.trails[4], shared::NO_TRAIL);
    EXPECT_EQ(tree.trails[9], shared::NO_TRAIL);
    expect_every_light_once(tree, lights);
    EXPECT_TRUE(build_light_tree({}).nodes.empty());
    EXPECT_TRUE(build_light_tree(std::vector<LightBounds>(3)).nodes.empty());
}

// Places that halve the distance to the origin again and again, and many in one place: the worst for a
// splitter that looks at space.
TEST(LightTree, StaysShallowEnoughForItsTrails) {
    std::vector<LightBounds> nested = random_lights(1, 1);
    nested.resize(1);
    for (int i = 0; i < 120; ++i) {
        LightBounds light = nested.front();
        light.lower = light.upper = glm::vec3(std::ldexp(1.0f, -i), 0, 0);
        light.intensity = std::ldexp(1.0, -i / 2);
        nested.push_back(light);
    }
    expect_every_light_once(build_light_tree(nested), nested);
    const std::vector<LightBounds> same(10000, nested.front());
    const LightTree tree = build_light_tree(same);
    expect_every_light_once(tree, same);
    EXPECT_LE(tree.depth, 14u) << "halves: 2^14 > 10000";
}

double angle(const glm::vec3& a, const glm::vec3& b) {
    return std::atan2(glm::length(glm::cross(glm::dvec3(a), glm::dvec3(b))),
                      glm::dot(glm::dvec3(a), glm::dvec3(b)));
}

// What merging makes of a chain of lights must contain each of them.
TEST(LightTree, MergedBoundsContainBothSides) {
    for (std::uint32_t seed = 0; seed < 200; ++seed) {
        const std::vector<LightBounds> lights = random_lights(2 + seed % 12, seed);
        LightBounds all = lights[0];
        double intensity = lights[0].intensity;
        for (std::size_t i = 1; i < lights.size(); ++i) {
            all = merge(all, lights[i]);
            intensity += lights[i].intensity;
        }
        EXPECT_NEAR(all.intensity, intensity, 1e-9 * intensity);
        for (const LightBounds& light : lights) {
            EXPECT_TRUE(glm::all(glm::lessThanEqual(all.lower, light.lower)));
            EXPECT_TRUE(glm::all(glm::greaterThanEqual(all.upper, light.upper)));
            EXPECT_LE(all.cos_emission, light.cos_emission);
            EXPECT_TRUE(all.two_sided || !light.two_sided);
            const double half = std::acos(std::clamp(all.cos_normals, -1.0f, 1.0f));
            const double needed = angle(all.axis, light.axis) + std::acos(light.cos_normals);
            EXPECT_LE(std::min(needed, std::acos(-1.0)), half + 2e-3);
        }
    }
}

TEST(LightTree, OppositeNormalsMakeAWholeSphere) {
    LightBounds up;
    up.axis = glm::vec3(0, 1, 0);
    LightBounds down = up;
    down.axis = -up.axis;
    EXPECT_EQ(merge(up, down).cos_normals, -1.0f);
    EXPECT_EQ(merge(up, up).cos_normals, 1.0f);
}

TEST(LightTree, IsTheSameForAnyNumberOfThreads) {
    const std::vector<LightBounds> lights = random_lights(20000, 11);
    LightTree many;
    tbb::task_arena(4).execute([&] { many = build_light_tree(lights); });
    LightTree alone;
    tbb::task_arena(1).execute([&] { alone = build_light_tree(lights); });
    EXPECT_EQ(many.trails, alone.trails);
    ASSERT_EQ(many.nodes.size(), alone.nodes.size());
    EXPECT_EQ(std::memcmp(many.nodes.data(), alone.nodes.data(), many.nodes.size() * sizeof(LightTreeNode)),
              0);
}

} // namespace
} // namespace ajar::test
