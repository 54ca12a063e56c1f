// Spheres and suns: where samples go, how dense, what a ray meets, and closed forms.
#include "light_functions.hpp"
#include "support/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ajar::test {
namespace {

using namespace shared;
constexpr double PI = std::numbers::pi;
constexpr float NO_LIMIT = 3.402823e38f;

// Of light 0, as doubles say it.
struct Case {
    const char* name;
    Lighting lighting{};
    glm::vec3 point{0};
    glm::dvec3 axis{0};              // unit, towards the middle of the light
    double cap = 0;                  // 1 - cos of half its angular diameter
    double distance = 0, radius = 0; // spheres
};

Light lamp(glm::vec3 position, float radius) {
    Light light;
    light.position = position;
    light.radius = radius;
    return light;
}

Case sphere_case(const char* name, glm::vec3 point, glm::vec3 center, float radius, bool mesh) {
    Case c{name, {}, point};
    if (mesh)
        c.lighting.spheres.push_back({0, center, radius, glm::vec3(2)});
    else
        c.lighting.scene.lights.push_back(lamp(center, radius));
    const glm::dvec3 to_center = glm::dvec3(center) - glm::dvec3(point);
    c.distance = glm::length(to_center);
    c.radius = c.lighting.table().lights[0].extent; // a mesh's is larger by its rounding
    c.axis = to_center / c.distance;
    const double sine2 = c.radius * c.radius / (c.distance * c.distance);
    c.cap = sine2 >= 1 ? 2 : sine2 / (1 + std::sqrt(1 - sine2));
    return c;
}

Case sun_case(const char* name, float diameter) {
    Case c{name};
    Light light;
    light.kind = LightKind::directional;
    light.direction = glm::normalize(glm::vec3(0.4f, -1, 0.3f));
    light.angular_diameter = diameter;
    light.intensity = glm::vec3(3);
    c.lighting.scene.lights.push_back(light);
    c.axis = -glm::dvec3(light.direction);
    c.cap = 2 * std::pow(std::sin(0.25 * diameter), 2);
    return c;
}

std::vector<Case> sphere_cases() {
    return {sphere_case("middling", {0, 0, 0}, {1, 2, 0.5f}, 0.7f, false),
            sphere_case("far", {3, 0, 0}, {1e4f, 2e4f, -1e4f}, 1, false),
            sphere_case("touched", {0, 0, 0}, {0, 1.0001f, 0}, 1, false),
            sphere_case("from within", {0.2f, 0.3f, 0}, {0, 0.5f, 0}, 1, false),
            sphere_case("a mesh", {0.2f, 0.3f, 0}, {-1, -2, 2}, 0.5f, true)};
}

std::vector<Case> all_cases() {
    std::vector<Case> cases = sphere_cases();
    cases.push_back(sun_case("the sun", 0.00925f));
    cases.push_back(sun_case("a wide sun", 2.0f));
    return cases;
}

class SoftLight : public LightFunctions {
  protected:
    static std::vector<LightItem> samples(const Case& c, std::size_t count = 200000) {
        return sample(c.lighting, 0, c.point, count, 21);
    }

    static std::vector<LightItem> meet(const Case& c, std::vector<LightItem> items, bool camera = false,
                                       float limit = NO_LIMIT) {
        for (LightItem& item : items) {
            item.point = c.point;
            item.delta = camera ? 1 : 0;
            item.distance = limit;
        }
        return run(LIGHTS_SOFT, c.lighting, std::move(items));
    }
};

// 1 - cos of the angle between unit vectors, however small.
double cap_of(glm::dvec3 a, glm::dvec3 b) { return 0.5 * glm::dot(a - b, a - b); }

TEST_F(SoftLight, DirectionsFillTheConeEvenly) {
    for (const Case& c : all_cases()) {
        const glm::dvec3 side = glm::normalize(
            glm::cross(c.axis, std::abs(c.axis.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 0, 1)));
        const glm::dvec3 up = glm::cross(side, c.axis);
        const int bins = 16;
        std::vector<double> observed(bins * bins, 0);
        const std::vector<LightItem> all = samples(c);
        for (const LightItem& item : all) {
            const glm::dvec3 d(item.direction);
            const double h = cap_of(d, c.axis) / c.cap;
            ASSERT_LE(h, 1 + 1e-6 / std::sqrt(c.cap)) << c.name;
            const double turn = std::atan2(glm::dot(d, up), glm::dot(d, side)) / (2 * PI) + 0.5;
            const int row = std::clamp(static_cast<int>(h * bins), 0, bins - 1);
            const int column = std::clamp(static_cast<int>(turn * bins), 0, bins - 1);
            observed[static_cast<std::size_t>(row * bins + column)] += 1;
        }
        // A far sphere's directions are few as floats: its cells are no longer even.
        if (std::sqrt(c.cap) < 1e-3) continue;
        const std::vector<double> expected(bins * bins, static_cast<double>(all.size()) / (bins * bins));
        EXPECT_GT(chi_square(observed, expected).p, sidak_level(SIGNIFICANCE, all_cases().size())) << c.name;
    }
}

TEST_F(SoftLight, StatesTheInverseOfItsSolidAngle) {
    for (const Case& c : all_cases())
        for (const LightItem& item : samples(c, 1000)) {
            const double expected = 1 / (2 * PI * c.cap);
            // Where a sphere is touched, its distance beyond the radius has few digits.
            ASSERT_NEAR(item.pdf, expected, (c.distance > 1.01 * c.radius ? 2e-6 : 1e-3) * expected)
                << c.name;
            ASSERT_EQ(item.delta, 0u);
            ASSERT_EQ(item.triangle, NO_TRIANGLE);
        }
}

TEST_F(SoftLight, SamplesEndOnTheSphere) {
    for (const Case& c : sphere_cases())
        for (const LightItem& item : samples(c, 10000)) {
            const glm::dvec3 end = double{item.distance} * glm::dvec3(item.direction);
            const double radius = glm::length(end - c.axis * c.distance);
            const double slack = 2e-7 * c.distance + 4e-3 * c.radius; // the outline is met at a slant
            ASSERT_NEAR(radius, c.radius, slack) << c.name;
            if (c.cap < 2) {
                ASSERT_LE(item.distance, c.distance) << c.name;
            }
        }
}

// E = pi L (r / d)^2 cos, for a sphere wholly above the horizon; pi L from within one that shines inwards
// too.
TEST_F(SoftLight, IrradianceOfASphereHasAClosedForm) {
    for (const Case& c : sphere_cases()) {
        const bool within = c.cap == 2;
        const glm::dvec3 normal =
            within ? glm::dvec3(0, 1, 0) : glm::normalize(c.axis + glm::dvec3(0.2, 0.1, 0) * (1 - c.cap));
        const double cosine = glm::dot(normal, c.axis);
        if (!within && c.cap > 0.5) continue; // reaches below the horizon
        Moments moments;
        for (const LightItem& item : samples(c))
            moments.add(double{item.radiance.x} *
                        std::max(glm::dot(glm::dvec3(item.direction), normal), 0.0) / item.pdf);
        const double radiance = c.lighting.spheres.empty() ? 1 / (PI * c.radius * c.radius) : 2;
        const double expected =
            PI * radiance * (within ? 1 : cosine * c.radius * c.radius / (c.distance * c.distance));
        EXPECT_GT(mean_p_value(moments, expected, 2e-5 * expected), sidak_level(SIGNIFICANCE, 5))
            << c.name << ": " << moments.mean() << " for " << expected;
    }
}

TEST_F(SoftLight, ASunKeepsItsIrradianceAtNormalIncidence) {
    for (const float diameter : {0.001f, 0.00925f, 0.5f, 2.0f, 3.1415926f}) {
        const Case c = sun_case("sun", diameter);
        Moments moments;
        for (const LightItem& item : samples(c)) {
            moments.add(double{item.radiance.x} * glm::dot(glm::dvec3(item.direction), c.axis) / item.pdf);
            ASSERT_EQ(item.distance, NO_LIMIT);
        }
        EXPECT_GT(mean_p_value(moments, 3, 3e-5), sidak_level(SIGNIFICANCE, 5)) << diameter;
    }
}

TEST_F(SoftLight, FarAwayASpotWithARadiusIsTheSpot) {
    Case c{"spot"};
    Light light = lamp({0, 40, 0}, 0.1f);
    light.kind = LightKind::spot;
    light.direction = glm::vec3(0, -1, 0);
    light.inner_cone_angle = 0.2f;
    light.outer_cone_angle = 0.5f;
    light.range = 60;
    c.lighting.scene.lights.push_back(light);
    light.radius = 0;
    Lighting sharp;
    sharp.scene.lights.push_back(light);
    for (const float x : {0.0f, 5.0f, 12.0f, 16.0f, 30.0f}) {
        c.point = glm::vec3(x, 0, 0);
        const double expected = sample(sharp, 0, c.point, 1, 1)[0].radiance.x;
        const LightItem soft = samples(c, 1)[0];
        EXPECT_NEAR(soft.radiance.x / soft.pdf, expected, 1e-4 * expected) << x;
    }
}

TEST_F(SoftLight, AMeshShinesOutwardsOnly) {
    const Case c = sphere_case("inside a mesh", {0.1f, 0, 0}, {0, 0, 0}, 1, true);
    std::vector<LightItem> items = samples(c, 100);
    for (const LightItem& item : items) EXPECT_EQ(item.pdf, 0.0f);
    for (const LightItem& item : meet(c, items)) EXPECT_EQ(item.triangle, 0u);
}

TEST_F(SoftLight, RaysMeetItWhereItIsSampled) {
    for (const Case& c : all_cases()) {
        std::vector<LightItem> items = samples(c, 20000);
        std::erase_if(items,
                      [](const LightItem& item) { return item.uv.x > 0.99f; }); // rounding at the outline
        const std::vector<LightItem> met = meet(c, items);
        std::size_t missed = 0;
        for (std::size_t i = 0; i < met.size(); ++i) {
            if (met[i].triangle != 1) {
                ++missed;
                continue;
            }
            ASSERT_EQ(met[i].light, 0u);
            ASSERT_NEAR(met[i].pdf, items[i].pdf, 1e-6f * items[i].pdf) << c.name;
            ASSERT_EQ(met[i].radiance, items[i].radiance) << c.name;
        }
        EXPECT_EQ(missed, 0u) << c.name;
        if (c.radius == 0 || c.cap == 2) continue;
        // Turned away, or with something in between.
        for (LightItem& item : items) item.direction = -item.direction;
        for (const LightItem& item : meet(c, items)) ASSERT_EQ(item.triangle, 0u) << c.name;
        for (LightItem& item : items) item.direction = -item.direction;
        for (const LightItem& item : meet(c, items, false, static_cast<float>(0.9 * (c.distance - c.radius))))
            ASSERT_EQ(item.triangle, 0u) << c.name;
    }
}

TEST_F(SoftLight, RaysOutsideItsConeMissIt) {
    for (const Case& c : all_cases()) {
        if (c.cap == 2) continue;
        std::vector<LightItem> items(20000);
        std::mt19937 random(4);
        for (LightItem& item : items) {
            glm::dvec3 d(0);
            do {
                d = glm::dvec3(uniform(random), uniform(random), uniform(random)) * 2.0 - 1.0;
                d = glm::normalize(d);
                if (random() % 2 == 0) d = glm::normalize(c.axis + d * 3.0 * std::sqrt(c.cap)); // near by
            } while (cap_of(d, c.axis) < 1.02 * c.cap + 1e-6 * std::sqrt(c.cap));
            item.direction = glm::vec3(d);
        }
        for (const LightItem& item : meet(c, items)) ASSERT_EQ(item.triangle, 0u) << c.name;
    }
}

TEST_F(SoftLight, TheCameraSeesMeshesAndNoLamps) {
    for (const Case& c : all_cases())
        for (const LightItem& item : meet(c, samples(c, 10), true))
            EXPECT_EQ(item.triangle, c.lighting.spheres.empty() ? 0u : 1u) << c.name;
}

TEST_F(SoftLight, ASunIsHiddenByAnything) {
    const Case c = sun_case("sun", 0.2f);
    for (const LightItem& item : meet(c, samples(c, 10), false, 1e30f)) EXPECT_EQ(item.triangle, 0u);
}

// More lamps than rays are tried against: those beyond are known to light sampling alone.
TEST_F(SoftLight, RaysMeetNoMoreLampsThanTheTableHasRoomFor) {
    Case c{"many"};
    for (int i = 0; i < 100; ++i)
        c.lighting.scene.lights.push_back(lamp({0, 0, 10.0f + static_cast<float>(i)}, 1));
    LightItem ahead{};
    ahead.direction = glm::vec3(0, 0, 1);
    EXPECT_EQ(meet(c, {ahead})[0].triangle, MAX_SOFT_LIGHTS);
    EXPECT_EQ(meet(c, {ahead}, false, 45.5f)[0].triangle, 37u);
    for (const std::uint32_t light : {0u, 63u, 64u, 99u}) {
        const LightItem item = sample(c.lighting, light, {0, 0, 0}, 1, 1)[0];
        EXPECT_EQ(item.delta, light < MAX_SOFT_LIGHTS ? 0u : 1u);
        EXPECT_GT(item.pdf, 0.0f);
    }
}

} // namespace
} // namespace ajar::test
