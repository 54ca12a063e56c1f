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

// A node's child as the kernels decode it, after shaders/shared/light_tree.glsl.h.
struct Decoded {
    glm::dvec3 center;
    double radius = 0;
    glm::dvec3 axis;
    double normals = 0;  // radians: half angle of the cone of normals
    double emission = 0; // how far light leaves it
    double intensity = 0;
    bool two_sided = false;
};

double snorm(std::uint32_t word, int byte) {
    return static_cast<std::int8_t>(word >> (8 * byte)) / double{shared::LIGHT_TREE_SNORM};
}

Decoded decode_root(const shared::LightTreeRoot& root) {
    return {root.center,
            root.radius,
            {snorm(root.axis, 0), snorm(root.axis, 1), snorm(root.axis, 2)},
            std::acos(snorm(root.cones, 0)),
            std::acos(snorm(root.cones, 1)),
            root.intensity,
            (root.flags & shared::LIGHT_TREE_TWO_SIDED) != 0};
}

Decoded decode(const LightTreeNode& node, int k, const Decoded& parent) {
    Decoded d;
    for (int a = 0; a < 3; ++a) {
        const double step = (node.place[k] >> (10 * a)) & shared::LIGHT_TREE_PLACE_STEPS;
        d.center[a] = parent.center[a] + parent.radius * (2 * step / shared::LIGHT_TREE_PLACE_STEPS - 1);
        d.axis[a] = snorm(node.axis[k], a);
    }
    const double root = ((node.radii >> (8 * k)) & 255u) / double{shared::LIGHT_TREE_RADIUS_STEPS};
    d.radius = parent.radius * root * root;
    d.normals = std::acos(snorm(node.normals, k));
    d.emission = std::acos(snorm(node.emission, k));
    const std::uint32_t level = node.axis[k] >> 24;
    d.intensity = level == 0 ? 0 : std::ldexp(1 + (level & 7) / 8.0, static_cast<int>(level >> 3) - 31);
    d.two_sided = (node.place[k] & shared::LIGHT_TREE_TWO_SIDED) != 0;
    return d;
}

// What a walk meets: every light with its way, and what all nodes on the way say.
struct Leaf {
    std::uint32_t light = 0;
    std::uint32_t trail = 0;
    std::vector<Decoded> way; // from the root to the light itself
};
using Visit = std::function<void(const Leaf&)>;

void visit(const LightTree& tree, std::uint32_t index, const Leaf& so_far, const Visit& leaf) {
    const LightTreeNode& node = tree.nodes[index];
    const std::uint32_t nodes = node.nodes >> shared::LIGHT_TREE_COUNT_SHIFT;
    const auto depth = static_cast<std::uint32_t>(so_far.way.size()) - 1;
    for (std::uint32_t k = 0; k < 4; ++k) {
        const Decoded child = decode(node, static_cast<int>(k), so_far.way.back());
        if (child.intensity == 0) continue;
        Leaf next = so_far;
        next.way.push_back(child);
        next.trail |= k << (shared::LIGHT_TREE_TRAIL_TOP - 2 - 2 * depth);
        next.light = node.lights[k];
        if (k < nodes)
            visit(tree, (node.nodes & shared::LIGHT_TREE_FIRST) + k, next, leaf);
        else
            leaf(next);
    }
}

void visit(const LightTree& tree, const Visit& leaf) {
    visit(tree, 0, Leaf{0, 0, {decode_root(tree.root)}}, leaf);
}

void expect_every_light_once(const LightTree& tree, std::span<const LightBounds> lights) {
    std::vector<int> seen(lights.size(), 0);
    visit(tree, [&](const Leaf& leaf) {
        ASSERT_LT(leaf.light, lights.size());
        ++seen[leaf.light];
        EXPECT_EQ(tree.trails[leaf.light], leaf.trail);
        EXPECT_LE(leaf.way.size() - 1, tree.depth);
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
    EXPECT_TRUE(build_light_tree({}).empty);
    EXPECT_TRUE(build_light_tree(std::vector<LightBounds>(3)).empty);
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
    EXPECT_LE(tree.depth, 7u) << "quarters: 4^7 > 10000";
}

double angle(const glm::vec3& a, const glm::vec3& b) {
    return std::atan2(glm::length(glm::cross(glm::dvec3(a), glm::dvec3(b))),
                      glm::dot(glm::dvec3(a), glm::dvec3(b)));
}

// Quantising may only widen: else a light that can light a point would be out of its reach.
TEST(LightTree, NodesContainTheLightsBelowThem) {
    const std::vector<LightBounds> lights = random_lights(3000, 8);
    constexpr double AXIS_ERROR = 0.008; // of three numbers in steps of 1/127; the kernels allow for it
    visit(build_light_tree(lights), [&](const Leaf& leaf) {
        const LightBounds& light = lights[leaf.light];
        for (const Decoded& node : leaf.way) {
            const glm::dvec3 farthest = glm::max(glm::abs(glm::dvec3(light.lower) - node.center),
                                                 glm::abs(glm::dvec3(light.upper) - node.center));
            EXPECT_LE(glm::length(farthest), node.radius * (1 + 1e-5));
            const double needed =
                angle(glm::vec3(node.axis), light.axis) + std::acos(light.cos_normals) - AXIS_ERROR;
            EXPECT_LE(std::min(needed, std::acos(-1.0)), node.normals + 2e-3);
            EXPECT_GE(node.emission, std::acos(light.cos_emission) - 1e-6);
            EXPECT_TRUE(node.two_sided || !light.two_sided);
        }
    });
}

TEST(LightTree, KnowsWhichSiblingShinesBrightest) {
    std::vector<LightBounds> lights = random_lights(1, 1);
    lights.resize(1);
    for (int i = 1; i < 4; ++i) {
        lights.push_back(lights[0]);
        lights.back().lower += static_cast<float>(i);
        lights.back().upper += static_cast<float>(i);
        lights.back().intensity = lights[0].intensity * std::ldexp(1.0, 3 * i); // 8, 64, 512
    }
    std::vector<double> found(4, 0);
    visit(build_light_tree(lights), [&](const Leaf& leaf) { found[leaf.light] = leaf.way.back().intensity; });
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(found[3] / found[i], std::ldexp(1.0, 9 - 3 * i), 0.07 * 512);
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
