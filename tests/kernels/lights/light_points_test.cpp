// Light samplers at many points among lights of every kind: probabilities sum to 1, are those of picking, and
// reach every light that can light the point.
#include "light_functions.hpp"
#include "support/statistics.hpp"

#include <algorithm>
#include <cmath>

namespace ajar::test {
namespace {

using namespace shared;

constexpr std::size_t POINTS = 1000;

glm::vec3 in_cube(std::mt19937& random) {
    std::uniform_real_distribution<float> unit(-1, 1);
    return {unit(random), unit(random), unit(random)};
}

// Triangles of all sizes and powers in a cube of 20 m, some two-sided; punctual lights; a sky.
Lighting scattered_lights(std::uint32_t sampler, std::size_t triangles) {
    std::mt19937 random(17);
    Lighting lighting;
    lighting.sampler = sampler;
    lighting.features = FEATURE_SPECULAR; // receivers have lobes
    lighting.scene_radius = 20;
    for (std::size_t i = 0; i < triangles; ++i) {
        EmissiveTriangle t;
        t.p0 = 10.0f * in_cube(random);
        const float size = std::exp2(3 * in_cube(random).x - 2);
        t.p1 = t.p0 + size * in_cube(random);
        t.p2 = t.p0 + size * in_cube(random);
        t.area = 0.5f * glm::length(glm::cross(t.p1 - t.p0, t.p2 - t.p0));
        t.emission = glm::vec3(std::exp(3 * in_cube(random).x));
        t.two_sided = i % 7 == 0;
        lighting.triangles.push_back(t);
    }
    for (int i = 0; i < 8; ++i) {
        Light light;
        light.kind = i % 2 == 0 ? LightKind::point : LightKind::spot;
        light.position = 10.0f * in_cube(random);
        light.direction = glm::normalize(in_cube(random));
        light.outer_cone_angle = 0.2f + 0.1f * static_cast<float>(i);
        light.radius = i < 4 ? 0 : 0.1f * static_cast<float>(i);
        lighting.scene.lights.push_back(light);
    }
    Light sun;
    sun.kind = LightKind::directional;
    sun.intensity = glm::vec3(0.01f);
    lighting.scene.lights.push_back(sun);
    sun.angular_diameter = 0.1f;
    lighting.scene.lights.push_back(sun);
    for (int i = 0; i < 4; ++i)
        lighting.spheres.push_back({0, 10.0f * in_cube(random), 0.5f, glm::vec3(0.3f)});
    lighting.scene.environment.emplace().scale = glm::vec3(0.002f);
    return lighting;
}

std::vector<LightItem> receivers(std::size_t count) {
    std::mt19937 random(23);
    std::vector<LightItem> items(count);
    for (LightItem& item : items) {
        item.point = 11.0f * in_cube(random);
        item.direction = glm::normalize(in_cube(random));
        item.triangle = static_cast<std::uint32_t>(random()); // any lobe; one in 32 has no share
    }
    return items;
}

class LightsAroundPoints : public LightFunctions, public testing::WithParamInterface<std::uint32_t> {
  protected:
    // pmf[point * lights + light]
    static std::vector<double> all_pmfs(const Lighting& lighting, const std::vector<LightItem>& points,
                                        std::size_t lights) {
        std::vector<LightItem> items;
        items.reserve(points.size() * lights);
        for (const LightItem& point : points)
            for (std::size_t l = 0; l < lights; ++l) {
                items.push_back(point);
                items.back().light = static_cast<std::uint32_t>(l);
            }
        std::vector<double> pmfs;
        for (const LightItem& item : run(LIGHTS_PMF, lighting, std::move(items))) pmfs.push_back(item.pdf);
        return pmfs;
    }
};

INSTANTIATE_TEST_SUITE_P(All, LightsAroundPoints, testing::ValuesIn(all_light_samplers()),
                         [](const auto& row) { return light_samplers()[row.index].name; });

TEST_P(LightsAroundPoints, HaveProbabilitiesThatSumToOne) {
    const Lighting lighting = scattered_lights(GetParam(), 200);
    const std::size_t lights = lighting.table().lights.size();
    const std::vector<double> pmfs = all_pmfs(lighting, receivers(POINTS), lights);
    for (std::size_t p = 0; p < POINTS; ++p) {
        double sum = 0;
        for (std::size_t l = 0; l < lights; ++l) sum += pmfs[p * lights + l];
        // Each of the tree's decisions rounds its two probabilities.
        ASSERT_NEAR(sum, 1, 2e-5) << "at point " << p;
    }
}

TEST_P(LightsAroundPoints, ArePickedAsOftenAsTheirProbabilitySays) {
    const Lighting lighting = scattered_lights(GetParam(), 200);
    const std::size_t lights = lighting.table().lights.size();
    constexpr std::size_t PLACES = 12;
    constexpr std::size_t PICKS = 40000;
    const std::vector<LightItem> points = receivers(PLACES);
    const std::vector<double> pmfs = all_pmfs(lighting, points, lights);
    std::mt19937 random(31);
    for (std::size_t p = 0; p < PLACES; ++p) {
        std::vector<LightItem> items(PICKS, points[p]);
        for (LightItem& item : items) item.uv.x = uniform(random);
        std::vector<double> observed(lights, 0);
        for (const LightItem& item : run(LIGHTS_PICK, lighting, std::move(items))) {
            ASSERT_LT(item.light, lights);
            // To the last bit, for MIS at a light that was met by chance.
            ASSERT_EQ(static_cast<double>(item.pdf), pmfs[p * lights + item.light]) << "point " << p;
            observed[item.light] += 1;
        }
        std::vector<double> expected;
        for (std::size_t l = 0; l < lights; ++l)
            expected.push_back(pmfs[p * lights + l] * static_cast<double>(PICKS));
        EXPECT_GT(chi_square(observed, expected).p, sidak_level(SIGNIFICANCE, 4 * PLACES)) << "point " << p;
    }
}

TEST_P(LightsAroundPoints, AreWithinReachWhereverTheyCanLightThePoint) {
    const Lighting lighting = scattered_lights(GetParam(), 200);
    const std::size_t lights = lighting.table().lights.size();
    const std::vector<LightItem> points = receivers(POINTS);
    const std::vector<double> pmfs = all_pmfs(lighting, points, lights);
    std::vector<LightItem> items;
    std::mt19937 random(37);
    for (const LightItem& point : points)
        for (std::size_t l = 0; l < lights; ++l) {
            items.push_back(point);
            items.back().light = static_cast<std::uint32_t>(l);
            items.back().uv = glm::vec2(uniform(random), uniform(random));
        }
    std::vector<LightItem> samples = items;
    samples = run(LIGHTS_SAMPLE, lighting, std::move(samples));
    std::size_t lit = 0;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const bool above = glm::dot(samples[i].direction, points[i / lights].direction) > 0;
        if (!above || !(samples[i].pdf > 0) || samples[i].radiance == glm::vec3(0)) continue;
        ++lit;
        ASSERT_GT(pmfs[i], 0.0) << "light " << i % lights << " at point " << i / lights;
    }
    EXPECT_GT(lit, POINTS * lights / 10) << "the test sees light";
}

// A tree that looks at the point must be nearer to the truth than one number for all points.
TEST_F(LightFunctions, TreePicksTheNearLightsMore) {
    Lighting lighting;
    lighting.sampler = LIGHT_SAMPLER_TREE;
    for (int i = 0; i < 64; ++i) {
        EmissiveTriangle t; // a row of equal lamps along x, facing down
        t.p0 = glm::vec3(2 * i, 1, 0);
        t.p1 = t.p0 + glm::vec3(0.1f, 0, 0);
        t.p2 = t.p0 + glm::vec3(0, 0, 0.1f);
        t.area = 0.005f;
        t.emission = glm::vec3(1);
        lighting.triangles.push_back(t);
    }
    std::vector<LightItem> items(64);
    for (std::size_t i = 0; i < 64; ++i) {
        items[i].point = glm::vec3(2 * 20, 0, 0);
        items[i].direction = glm::vec3(0, 1, 0);
        items[i].light = static_cast<std::uint32_t>(i);
    }
    const std::vector<LightItem> found = run(LIGHTS_PMF, lighting, items);
    EXPECT_GT(found[20].pdf, 0.25f) << "straight above: two thirds of all light comes from there";
    EXPECT_LT(found[60].pdf, 0.01f);
}

// A floor that is mostly a glossy mirror, below a row of equal lamps: picks follow what the viewer sees.
TEST_F(LightFunctions, TreePicksTheLightsThatALobeReflects) {
    Lighting lighting;
    lighting.sampler = LIGHT_SAMPLER_TREE;
    lighting.features = FEATURE_SPECULAR;
    for (int i = 0; i < 64; ++i)
        lighting.triangles.push_back(
            triangle(glm::vec3(i, 2, 0), glm::vec3(i + 0.1f, 2, 0), glm::vec3(i, 2, 0.1f)));
    constexpr std::uint32_t ROUGHNESS = 6; // of 31
    constexpr std::uint32_t SHARE = 28;    // of 32
    const auto pmf_of = [&](std::uint32_t light, std::uint32_t lobe) {
        LightItem item{};
        item.direction = glm::vec3(0, 1, 0);
        item.light = light;
        item.triangle = lobe;
        return run(LIGHTS_PMF, lighting, {item}).front().pdf;
    };
    // Towards lamp 6, 18 degrees above the floor: (1, 1/3, 0) on the octahedron is (0.75, 0) of 1023.
    const std::uint32_t lobe = 767u | 255u << 11 | ROUGHNESS << 22 | SHARE << 27;
    EXPECT_GT(pmf_of(6, lobe), 3 * pmf_of(6, 0));
    EXPECT_LT(pmf_of(0, lobe), pmf_of(0, 0));
    EXPECT_GT(pmf_of(40, lobe), 0.0f) << "what the lobe hardly sees stays within reach";
}

} // namespace
} // namespace ajar::test
