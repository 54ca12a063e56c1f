// Point, spot and directional lights against the formulas of KHR_lights_punctual.
#include "light_functions.hpp"

#include <algorithm>
#include <cmath>

namespace ajar::test {
namespace {

using namespace shared;

class PunctualLights : public LightFunctions {
  protected:
    // What one light brings to points around it.
    static std::vector<LightItem> illuminate(const Light& light, const std::vector<glm::vec3>& points) {
        Lighting lighting;
        lighting.scene.lights.push_back(light);
        std::vector<LightItem> items(points.size());
        for (std::size_t i = 0; i < points.size(); ++i) items[i].point = points[i];
        return run(LIGHTS_SAMPLE, lighting, std::move(items));
    }

    static std::vector<glm::vec3> points_around(glm::vec3 center, float reach) {
        std::mt19937 random(2);
        std::vector<glm::vec3> points(2000);
        for (glm::vec3& p : points)
            p = center + reach * (2.0f * glm::vec3(uniform(random), uniform(random), uniform(random)) - 1.0f);
        return points;
    }

    static void expect_close(glm::vec3 got, glm::dvec3 expected) {
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(got[c], expected[c], 2e-5 * std::abs(expected[c]) + 1e-6);
    }

    static void expect_delta(const LightItem& item) {
        EXPECT_EQ(item.pdf, 1.0f);
        EXPECT_EQ(item.delta, 1u);
        EXPECT_EQ(item.triangle, NO_TRIANGLE);
    }
};

double window(double distance, double range) {
    return range > 0 ? std::max(std::min(1 - std::pow(distance / range, 4), 1.0), 0.0) : 1;
}

TEST_F(PunctualLights, PointLightFallsOffWithTheSquareAndEndsAtItsRange) {
    for (const float range : {0.0f, 3.0f}) {
        Light light;
        light.position = glm::vec3(10, 2, -4);
        light.intensity = glm::vec3(7, 1, 0.25f);
        light.range = range;
        int dark = 0;
        for (const LightItem& item : illuminate(light, points_around(light.position, 3))) {
            const glm::dvec3 to_light = glm::dvec3(light.position) - glm::dvec3(item.point);
            const double distance = glm::length(to_light);
            expect_close(item.radiance,
                         glm::dvec3(light.intensity) * window(distance, range) / (distance * distance));
            expect_close(item.direction, to_light / distance);
            EXPECT_NEAR(item.distance, distance, 1e-5);
            expect_delta(item);
            dark += item.radiance == glm::vec3(0) ? 1 : 0;
        }
        EXPECT_EQ(dark > 0, range > 0) << "a cube of that half side has corners beyond the range";
    }
}

TEST_F(PunctualLights, SpotLightHasTheExtensionsProfile) {
    for (const auto& [inner, outer] : {std::pair{0.0f, 0.7853982f}, {0.3f, 0.35f}, {0.5f, 1.5707963f}}) {
        Light light;
        light.kind = LightKind::spot;
        light.direction = glm::normalize(glm::vec3(1, -2, 0.5f));
        light.intensity = glm::vec3(3);
        light.range = 9;
        light.inner_cone_angle = inner;
        light.outer_cone_angle = outer;
        int full = 0;
        int partly = 0;
        std::vector<glm::vec3> points = points_around(light.position, 3);
        for (int i = 0; i <= 400; ++i) // along the cone's border
            points.push_back(2.0f * light.direction + static_cast<float>(i) * 0.01f * glm::vec3(2, 1, 0));
        for (const LightItem& item : illuminate(light, points)) {
            const glm::dvec3 to_light = glm::dvec3(light.position) - glm::dvec3(item.point);
            const double distance = glm::length(to_light);
            const double cosine = glm::dot(-to_light / distance, glm::dvec3(light.direction));
            const double scale = 1 / std::max(0.001, std::cos(double{inner}) - std::cos(double{outer}));
            const double linear = std::clamp(cosine * scale - std::cos(double{outer}) * scale, 0.0, 1.0);
            const double expected = 3 * linear * linear * window(distance, 9) / (distance * distance);
            // Narrow ramps magnify the rounding of the cosine.
            EXPECT_NEAR(item.radiance.x, expected, 1e-5 * scale * 3 / (distance * distance)) << linear;
            full += linear == 1 ? 1 : 0;
            partly += linear > 0 && linear < 1 ? 1 : 0;
            expect_delta(item);
        }
        EXPECT_GT(partly, 5);
        if (inner > 0) {
            EXPECT_GT(full, 5);
        }
    }
}

TEST_F(PunctualLights, DirectionalLightIsTheSameEverywhere) {
    Light light;
    light.kind = LightKind::directional;
    light.direction = glm::normalize(glm::vec3(1, -3, 2));
    light.intensity = glm::vec3(4, 5, 6);
    for (const LightItem& item : illuminate(light, points_around({}, 1000))) {
        EXPECT_EQ(item.radiance, light.intensity);
        EXPECT_EQ(item.direction, -light.direction);
        EXPECT_GT(item.distance, 1e30f);
        expect_delta(item);
    }
}

} // namespace
} // namespace ajar::test
