// Light records, their powers and their order.
#include "render/emission_means.hpp"
#include "render/light_table.hpp"
#include "shaders/shared/specialization.glsl.h"

#include <cmath>
#include <cstring>
#include <gtest/gtest.h>
#include <numbers>

namespace ajar {
namespace {

constexpr double PI = std::numbers::pi;

Light spot(float inner, float outer) {
    Light light;
    light.kind = LightKind::spot;
    light.inner_cone_angle = inner;
    light.outer_cone_angle = outer;
    return light;
}

// The extension's profile integrated over the sphere.
double spot_power_by_quadrature(const Light& light) {
    const double outer = std::cos(double{light.outer_cone_angle});
    const double scale = 1 / std::max(0.001, std::cos(double{light.inner_cone_angle}) - outer);
    const int steps = 1000000;
    double sum = 0;
    for (int i = 0; i < steps; ++i) {
        const double c = -1 + 2 * (i + 0.5) / steps;
        const double a = std::clamp((c - outer) * scale, 0.0, 1.0);
        sum += a * a * 2 / steps;
    }
    return 2 * PI * sum;
}

TEST(LightTable, PowersAreTheIntegralsOfWhatIsSentOut) {
    EmissiveTriangle triangle;
    triangle.emission = glm::vec3(3);
    triangle.area = 2;
    EXPECT_NEAR(light_power(triangle), 6 * PI, 1e-6);
    triangle.two_sided = true;
    EXPECT_NEAR(light_power(triangle), 12 * PI, 1e-6);

    Light light;
    EXPECT_NEAR(light_power(light, 5), 4 * PI, 1e-6);
    for (const auto& [inner, outer] :
         {std::pair{0.0f, 0.7f}, {0.5f, 0.52f}, {0.0f, 1.5f}, {0.3f, 0.3f}, {0.0f, 0.01f}}) {
        const double expected = spot_power_by_quadrature(spot(inner, outer));
        EXPECT_NEAR(light_power(spot(inner, outer), 5), expected, 2e-3 * expected) << inner << " " << outer;
    }
    light.kind = LightKind::directional;
    EXPECT_NEAR(light_power(light, 3), 9 * PI, 1e-5);

    Environment environment;
    environment.scale = glm::vec3(0.5f);
    EXPECT_NEAR(light_power(environment, 3), 4 * PI * 0.5 * 9 * PI, 1e-4);
}

TEST(LightTable, WeighsColoursByLuminance) {
    Light red;
    red.intensity = glm::vec3(1, 0, 0);
    Light green;
    green.intensity = glm::vec3(0, 1, 0);
    EXPECT_NEAR(light_power(green, 1) / light_power(red, 1), 0.7152 / 0.2126, 1e-4);
}

Scene small_scene() {
    Scene scene;
    scene.lights.resize(2);
    scene.lights[0].range = 4;
    scene.lights[1] = spot(0.2f, 0.4f);
    scene.lights[1].direction = glm::vec3(0, -1, 0);
    scene.environment = Environment{};
    return scene;
}

TEST(LightTable, OrdersTrianglesThenPunctualLightsThenTheEnvironment) {
    std::vector<EmissiveTriangle> triangles(3);
    for (EmissiveTriangle& t : triangles) {
        t.p1 = glm::vec3(1, 0, 0);
        t.p2 = glm::vec3(0, 1, 0);
        t.area = 0.5f;
    }
    triangles[1].emission = glm::vec3(1);
    triangles[1].triangle = 42;
    triangles[2].emission = glm::vec3(1);
    triangles[2].two_sided = triangles[2].textured = true;
    const LightTable table = build_light_table(small_scene(), triangles, 20);
    ASSERT_EQ(table.lights.size(), 6u);
    EXPECT_EQ(table.environment_light, 5u);
    EXPECT_EQ(table.lights[1].triangle, 42u);
    EXPECT_EQ(table.lights[2].kind,
              shared::LIGHT_TRIANGLE | shared::LIGHT_TWO_SIDED | shared::LIGHT_TEXTURED);
    EXPECT_EQ(table.lights[3].kind, shared::LIGHT_POINT);
    EXPECT_EQ(table.lights[3].p2.x, 1.0f / 16);
    EXPECT_EQ(table.lights[4].kind, shared::LIGHT_SPOT);
    EXPECT_EQ(table.lights[5].kind, shared::LIGHT_ENVIRONMENT);
    EXPECT_EQ(table.features, shared::FEATURE_EMISSIVE_TRIANGLES | shared::FEATURE_PUNCTUAL_LIGHTS |
                                  shared::FEATURE_CONSTANT_ENVIRONMENT);
    EXPECT_EQ(table.lights[0].power_pmf, 0.0f) << "it emits nothing";
    double sum = 0;
    double power = 0;
    for (std::size_t i = 0; i < 6; ++i) sum += table.lights[i].power_pmf, power += table.powers[i];
    EXPECT_EQ(sum, 1.0);
    for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(table.lights[i].power_pmf, table.powers[i] / power, 1e-6);
}

TEST(LightTable, PutsSoftLightsInARowSpheresBeforeSunsBeforeLamps) {
    Scene scene = small_scene();
    scene.lights[0].radius = 0.5f;
    scene.lights[0].range = 0;
    scene.lights.push_back(Light{});
    scene.lights[2].kind = LightKind::directional;
    scene.lights[2].angular_diameter = 0.4f;
    const std::vector<EmissiveSphere> spheres{{3, {1, 2, 3}, 0.25f, glm::vec3(7)}};
    const LightTable table = build_light_table(scene, {}, 2, spheres);
    ASSERT_EQ(table.lights.size(), 5u);
    EXPECT_EQ(table.soft_first, 1u);
    EXPECT_EQ(table.soft_count, 3u);
    EXPECT_EQ(table.lights[0].kind, shared::LIGHT_SPOT);
    EXPECT_EQ(table.lights[1].kind, shared::LIGHT_SPHERE);
    EXPECT_EQ(table.lights[1].p0, glm::vec3(1, 2, 3));
    EXPECT_EQ(table.lights[2].kind, shared::LIGHT_SUN | shared::LIGHT_LAMP);
    EXPECT_EQ(table.lights[3].kind, shared::LIGHT_SPHERE | shared::LIGHT_LAMP);
    EXPECT_NEAR(table.lights[3].radiance.x, 4 / PI, 1e-6) << "intensity 1 over pi r^2";
    EXPECT_NEAR(table.powers[1], 4 * PI * 0.0625 * 7 * PI, 1e-5);
    EXPECT_NEAR(table.powers[3], 4 * PI, 1e-5) << "as the point light's";
    EXPECT_EQ(table.environment_light, 4u);
    EXPECT_EQ(table.features, shared::FEATURE_SOFT_LIGHTS | shared::FEATURE_PUNCTUAL_LIGHTS |
                                  shared::FEATURE_CONSTANT_ENVIRONMENT);
}

TEST(LightTable, TakesLightsTooSmallToBeSoftAsPoints) {
    Scene scene;
    scene.lights.resize(2);
    scene.lights[0].radius = 1e-30f; // its radiance is no float
    scene.lights[1].kind = LightKind::directional;
    scene.lights[1].angular_diameter = 1e-8f;
    const LightTable table = build_light_table(scene, {}, 1);
    EXPECT_EQ(table.soft_count, 0u);
    EXPECT_EQ(table.lights[0].kind, shared::LIGHT_POINT);
    EXPECT_EQ(table.lights[1].kind, shared::LIGHT_DIRECTIONAL);
}

TEST(LightTable, SamplesTrianglesBySolidAngleWhereTheyAreLargeForTheScene) {
    std::vector<EmissiveTriangle> triangles(2);
    triangles[0].emission = triangles[1].emission = glm::vec3(1);
    triangles[0].area = 0.5f; // has nearly all the power
    triangles[1].area = 1e-3f;
    const auto wide = [&](float scene_radius) {
        return (build_light_table(Scene{}, triangles, scene_radius).features &
                shared::FEATURE_WIDE_TRIANGLES) != 0;
    };
    EXPECT_TRUE(wide(1));
    EXPECT_FALSE(wide(10));
    EXPECT_FALSE((build_light_table(Scene{}, {}, 1).features & shared::FEATURE_WIDE_TRIANGLES) != 0);
}

TEST(LightTable, CountsTheEnvironmentWithWhatLightSamplingIsToFind) {
    const Scene scene = small_scene();
    const LightTable whole = build_light_table(scene, {}, 2);
    const LightTable part = build_light_table(scene, {}, 2, {}, 0.25);
    ASSERT_EQ(part.environment_light, 2u);
    EXPECT_EQ(part.powers[1], whole.powers[1]);
    EXPECT_NEAR(part.powers[2], 0.25 * whole.powers[2], 1e-9);
    EXPECT_NEAR(part.distant_irradiance, 0.25 * whole.distant_irradiance, 1e-6);
    const LightTable none = build_light_table(scene, {}, 2, {}, 0);
    EXPECT_EQ(none.lights[2].power_pmf, 0);
    EXPECT_TRUE(none.distant.empty());
}

TEST(LightTable, WordsHoldRecordsThenTheAliasTable) {
    const LightTable table = build_light_table(small_scene(), {}, 2);
    const std::vector<glm::uvec4> words = table.words();
    shared::FrameRecord frame{};
    table.describe(frame);
    ASSERT_EQ(frame.alias_first, 12u);
    ASSERT_GE(words.size(), 12u + 4u);
    EXPECT_EQ(std::memcmp(words.data() + 4, &table.lights[1], sizeof table.lights[1]), 0);
    EXPECT_EQ(std::memcmp(words.data() + 12, table.alias.data(), 64), 0);
}

TEST(LightTable, OfASceneWithoutLightsCanStillBeUploaded) {
    const LightTable table = build_light_table(Scene{}, {}, 1);
    EXPECT_EQ(table.environment_light, shared::NO_LIGHT);
    EXPECT_EQ(table.features, 0u);
    EXPECT_FALSE(table.words().empty());
}

TEST(LightTable, GivesBrokenAndDegenerateLightsNoChance) {
    std::vector<EmissiveTriangle> triangles(4);
    for (EmissiveTriangle& t : triangles) t.emission = glm::vec3(1);
    triangles[1].area = NAN;
    triangles[2].area = 1;
    triangles[3].area = 1;
    triangles[3].emission = glm::vec3(-1);
    const LightTable table = build_light_table(Scene{}, triangles, 1);
    EXPECT_EQ(table.lights[2].power_pmf, 1.0f);
}

} // namespace
} // namespace ajar
