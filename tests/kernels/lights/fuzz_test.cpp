// Nothing that a scene file or a path can come up with makes a light return something that is not a number.
#include "light_functions.hpp"

#include <cmath>

namespace ajar::test {
namespace {

using namespace shared;

EmissiveTriangle nasty(glm::vec3 p0, glm::vec3 p1, glm::vec3 p2) {
    EmissiveTriangle t = triangle(p0, p1, p2, 1e4f);
    t.two_sided = true;
    return t;
}

Lighting nasty_lights(std::uint32_t features) {
    Lighting lighting;
    lighting.features = features;
    lighting.spheres = {{0, {0, 0, 0}, 1, glm::vec3(1e4f)},
                        {0, {1, 1, 1}, 1e-20f, glm::vec3(1)},
                        {0, {1e18f, 0, 0}, 1e18f, glm::vec3(1)}};
    lighting.triangles = {
        nasty({0, 0, 0}, {1, 0, 0}, {0, 1, 0}),                  // its plane holds many of the points below
        nasty({1, 1, 1}, {1, 1, 1}, {1, 1, 1}),                  // a point
        nasty({0, 0, 0}, {1, 1, 1}, {2, 2, 2}),                  // a line
        nasty({0, 0, 0}, {1e-20f, 0, 0}, {0, 1e-20f, 0}),        // its area underflows
        nasty({1e18f, 0, 0}, {0, 1e18f, 0}, {0, 0, 1e18f}),      // its squared distance does not fit far
        nasty({1e30f, 1e30f, 0}, {-1e30f, 0, 0}, {0, 0, 1e30f}), // nor does anything here
        nasty({1e6f, 0, 0}, {1e6f + 1, 0, 0}, {1e6f, 1e-3f, 1e6f}), // a needle
    };
    lighting.scene.lights.resize(8);
    lighting.scene.lights[1].kind = LightKind::spot;
    lighting.scene.lights[1].inner_cone_angle = lighting.scene.lights[1].outer_cone_angle = 0;
    lighting.scene.lights[2].kind = LightKind::directional;
    lighting.scene.lights[3].range = 1e-30f;
    lighting.scene.lights[4].radius = 0.5f;
    lighting.scene.lights[5].radius = 1e-18f;
    lighting.scene.lights[6].kind = LightKind::directional;
    lighting.scene.lights[6].angular_diameter = 3.1415927f;
    lighting.scene.lights[7].kind = LightKind::spot;
    lighting.scene.lights[7].radius = 1e18f;
    Environment e;
    e.width = 3;
    e.height = 2;
    e.radiance = {glm::vec3(0), glm::vec3(1e30f), glm::vec3(1e-30f),
                  glm::vec3(0), glm::vec3(1),     glm::vec3(0)};
    lighting.scene.environment = e;
    return lighting;
}

class NastyLights : public LightFunctions, public testing::WithParamInterface<std::uint32_t> {};
INSTANTIATE_TEST_SUITE_P(Triangles, NastyLights, testing::Values(0u, FEATURE_WIDE_TRIANGLES));

TEST_P(NastyLights, NeverGiveWhatIsNotANumber) {
    const Lighting lighting = nasty_lights(GetParam());
    const auto light_count = static_cast<std::uint32_t>(lighting.table().lights.size());
    std::mt19937 random(8);
    const std::vector<float> places{0,      1,    0.5f,  0.25f,  -1,    1e-6f, 1e-20f,
                                    1e-38f, 1e6f, 1e18f, -1e18f, 1e30f, 2};
    const std::vector<float> uniforms{0, 0x1p-24f, 0.5f, 1 - 0x1p-24f, 0.25f};
    const auto any = [&](const std::vector<float>& from) { return from[random() % from.size()]; };
    std::vector<LightItem> items(200000);
    for (LightItem& item : items) {
        item.light = static_cast<std::uint32_t>(random() % light_count);
        item.point = glm::vec3(any(places), any(places), random() % 2 == 0 ? 0.0f : any(places));
        item.uv.x = random() % 2 == 0 ? any(uniforms) : uniform(random);
        item.uv.y = random() % 2 == 0 ? any(uniforms) : uniform(random);
    }
    int without = 0;
    for (const LightItem& item : run(LIGHTS_SAMPLE, lighting, items)) {
        const auto tell = [&] {
            return ::testing::Message()
                   << "light " << item.light << " from " << item.point.x << " " << item.point.y << " "
                   << item.point.z << " at " << item.uv.x << " " << item.uv.y;
        };
        ASSERT_TRUE(std::isfinite(item.pdf) && item.pdf >= 0) << tell();
        for (int c = 0; c < 3; ++c) {
            ASSERT_TRUE(std::isfinite(item.radiance[c]) && item.radiance[c] >= 0) << tell();
            ASSERT_TRUE(std::isfinite(item.direction[c])) << tell();
        }
        if (item.pdf > 0) {
            ASSERT_NEAR(glm::length(item.direction), 1, 1e-4) << tell();
        } else {
            ASSERT_EQ(item.radiance, glm::vec3(0)) << tell();
            ++without;
        }
    }
    EXPECT_GT(without, 1000) << "the test must test something";
}

TEST_P(NastyLights, HaveADensityAtHitsThatIsANumber) {
    const Lighting lighting = nasty_lights(GetParam());
    std::mt19937 random(8);
    const std::vector<float> places{0, 1, -1, 0.5f, 1e-10f, 1e-20f, 1e-38f, 1e6f, 1e18f, -1e18f, 3e38f};
    std::vector<LightItem> items(20000);
    for (LightItem& item : items) {
        for (int c = 0; c < 3; ++c) item.point[c] = places[random() % places.size()];
        const float height = 2 * uniform(random) - 1;
        item.direction = glm::vec3(std::sqrt(1 - height * height), random() % 2 == 0 ? height : 0.0f, 0);
        item.triangle = static_cast<std::uint32_t>(random() % lighting.triangles.size());
    }
    for (const LightItem& item : run(LIGHTS_TRIANGLE_PDF, lighting, items))
        ASSERT_TRUE(std::isfinite(item.pdf) && item.pdf >= 0)
            << item.triangle << " from " << item.point.x << " " << item.point.y << " " << item.point.z;
}

} // namespace
} // namespace ajar::test
