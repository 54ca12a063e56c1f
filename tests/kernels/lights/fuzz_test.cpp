// Nothing that a scene file or a path can come up with makes a light return something that is not a number.
#include "light_functions.hpp"

#include <cmath>

namespace ajar::test {
namespace {

using namespace shared;

EmissiveTriangle triangle(glm::vec3 p0, glm::vec3 p1, glm::vec3 p2) {
    EmissiveTriangle t;
    t.p0 = p0;
    t.p1 = p1;
    t.p2 = p2;
    t.emission = glm::vec3(1e4f);
    t.two_sided = true;
    return t;
}

Lighting nasty_lights() {
    Lighting lighting;
    lighting.triangles = {
        triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}),             // its plane holds many of the points below
        triangle({1, 1, 1}, {1, 1, 1}, {1, 1, 1}),             // a point
        triangle({0, 0, 0}, {1, 1, 1}, {2, 2, 2}),             // a line
        triangle({0, 0, 0}, {1e-20f, 0, 0}, {0, 1e-20f, 0}),   // its area underflows
        triangle({1e18f, 0, 0}, {0, 1e18f, 0}, {0, 0, 1e18f}), // its squared distance does not fit far
        triangle({1e30f, 1e30f, 0}, {-1e30f, 0, 0}, {0, 0, 1e30f}),    // nor does anything here
        triangle({1e6f, 0, 0}, {1e6f + 1, 0, 0}, {1e6f, 1e-3f, 1e6f}), // a needle
    };
    lighting.scene.lights.resize(4);
    lighting.scene.lights[1].kind = LightKind::spot;
    lighting.scene.lights[1].inner_cone_angle = lighting.scene.lights[1].outer_cone_angle = 0;
    lighting.scene.lights[2].kind = LightKind::directional;
    lighting.scene.lights[3].range = 1e-30f;
    Environment e;
    e.width = 3;
    e.height = 2;
    e.radiance = {glm::vec3(0), glm::vec3(1e30f), glm::vec3(1e-30f),
                  glm::vec3(0), glm::vec3(1),     glm::vec3(0)};
    lighting.scene.environment = e;
    return lighting;
}

TEST_F(LightFunctions, NeverReturnWhatIsNotANumber) {
    const Lighting lighting = nasty_lights();
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

TEST_F(LightFunctions, DensityOfATriangleIsANumberForEveryHit) {
    std::mt19937 random(8);
    const std::vector<float> cosines{0, 1, -1, 1e-10f, 1e-38f, -1e-3f};
    const std::vector<float> sizes{0, 1, 1e-20f, 1e-38f, 1e20f, 3e38f};
    std::vector<LightItem> items(10000);
    for (LightItem& item : items) {
        const float cosine = cosines[random() % cosines.size()];
        item.direction = glm::vec3(std::sqrt(1 - cosine * cosine), cosine, 0);
        item.point = glm::vec3(0, 1, 0);
        item.distance = sizes[random() % sizes.size()];
        item.uv.x = sizes[random() % sizes.size()];
    }
    for (const LightItem& item : run(LIGHTS_TRIANGLE_PDF, nasty_lights(), items))
        ASSERT_TRUE(std::isfinite(item.pdf) && item.pdf >= 0)
            << item.direction.y << " " << item.distance << " " << item.uv.x;
}

} // namespace
} // namespace ajar::test
