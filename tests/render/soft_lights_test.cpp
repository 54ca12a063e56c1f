// Spheres and suns in whole renders: closed forms on a floor, and who sees whom.
#include "render_test.hpp"

#include <glm/gtc/constants.hpp>

namespace ajar::test {
namespace {

constexpr double PI = glm::pi<double>();
const glm::vec3 ALBEDO(0.8f, 0.5f, 0.2f);

class SoftLights : public RenderTestByStrategy {};
INSTANTIATE_TEST_SUITE_P(Strategies, SoftLights, testing::Values("bsdf", "light", "mis"),
                         [](const auto& row) { return std::string(row.param); });

void add_floor(SceneBuilder& builder) {
    builder.square({0, 0, 0}, {0, 1, 0}, 50, builder.material(lambert(ALBEDO)));
    builder.perspective({0, 1.2f, 3}, {0, 0, 0}, 0.7f);
}

// The floor's radiance, lit by a sphere of radiance 1 wholly above it.
RayRadiance floor_below_sphere(glm::dvec3 center, double radius) {
    return [=](const ViewRay& ray) -> std::optional<glm::dvec3> {
        if (ray.direction.y > -0.05) return std::nullopt;
        const glm::dvec3 to_center = center - meet_plane(ray, {0, 0, 0}, {0, 1, 0});
        const double distance = glm::length(to_center);
        const double cosine = to_center.y / distance;
        return glm::dvec3(ALBEDO) * (radius * radius / (distance * distance) * cosine);
    };
}

TEST_P(SoftLights, ALampLightsTheFloorByItsClosedForm) {
    SceneBuilder builder;
    add_floor(builder);
    const double radius = 0.35;
    builder.point_light({0.3f, 0.8f, 0.2f}, glm::vec3(static_cast<float>(PI * radius * radius)),
                        static_cast<float>(radius));
    const Scene scene = builder.build();
    RenderSettings settings = strategy_settings();
    settings.samples = 256;
    expect_radiance(render(scene, settings), scene.cameras[0], settings,
                    floor_below_sphere({0.3, 0.8, 0.2}, radius), 2e-4);
}

TEST_P(SoftLights, AMeshLightsTheFloorAsASphereAndShowsItself) {
    SceneBuilder builder;
    add_floor(builder);
    const glm::dvec3 center(0.1, 0.6, 0.2);
    builder.sphere_light(glm::vec3(center), 0.3f, builder.material(emitter({1, 1, 1})));
    const Scene scene = builder.build();
    RenderSettings settings = strategy_settings();
    settings.samples = 256;
    const RayRadiance floor = floor_below_sphere(center, 0.3);
    expect_radiance(
        render(scene, settings), scene.cameras[0], settings,
        [&](const ViewRay& ray) -> std::optional<glm::dvec3> {
            const glm::dvec3 to_center = center - ray.origin;
            const double aside = glm::length(to_center - ray.direction * glm::dot(to_center, ray.direction));
            if (aside < 0.299) return glm::dvec3(1);
            return aside > 0.301 ? floor(ray) : std::nullopt;
        },
        2e-4);
}

TEST_P(SoftLights, ASunLightsTheFloorAsIfItWereAPoint) {
    SceneBuilder builder;
    add_floor(builder);
    const glm::dvec3 direction = glm::normalize(glm::dvec3(0.3, -1, 0.2));
    builder.directional_light(glm::vec3(direction), {2, 2, 2}, 0.6f);
    const Scene scene = builder.build();
    RenderSettings settings = strategy_settings();
    settings.samples = 256;
    expect_radiance(render(scene, settings), scene.cameras[0], settings,
                    [&](const ViewRay& ray) -> std::optional<glm::dvec3> {
                        if (ray.direction.y > -0.05) return std::nullopt;
                        return glm::dvec3(ALBEDO) / PI * 2.0 * -direction.y;
                    });
}

TEST_F(RenderTest, TheNaiveIntegratorFindsSoftLights) {
    for (const bool sun : {false, true}) {
        SceneBuilder builder;
        add_floor(builder);
        if (sun)
            builder.directional_light({0.3f, -1, 0.2f}, {2, 2, 2}, 1);
        else
            builder.point_light({0.3f, 1, 0.2f}, {1, 1, 1}, 0.5f);
        const Scene scene = builder.build();
        RenderSettings settings = small_settings();
        const Image reference = render(scene, settings);
        settings.integrator = "naive";
        settings.seed = 1;
        settings.samples = 256;
        expect_equal_means(reference, render(scene, settings), sun ? "sun" : "lamp");
    }
}

// A mirror shows the lamp that the camera itself does not see.
TEST_F(RenderTest, LampsAreSeenInMirrorsAlone) {
    SceneBuilder builder;
    builder.square({0, 0, 0}, {0, 1, 0}, 50, builder.material(metal({1, 1, 1}, 0)));
    builder.point_light({0, 1, -2}, glm::vec3(static_cast<float>(PI)), 1); // radiance 1
    builder.perspective({0, 1, 3}, {0, 0, 0.5f}, 1.2f);
    const Scene scene = builder.build();
    const Image image = render(scene, small_settings());
    EXPECT_EQ(pixel(image, "", 16, 2), glm::dvec3(0)) << "the lamp itself";
    EXPECT_NEAR(pixel(image, "", 16, 16).x, 1, 1e-3) << "its mirror image";
}

} // namespace
} // namespace ajar::test
