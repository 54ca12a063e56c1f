// Whole renders whose every pixel has a closed form: light by lights of all kinds on planes and spheres.
#include "render_test.hpp"
#include "support/lambert.hpp"
#include "support/statistics.hpp"

#include <glm/gtc/constants.hpp>

namespace ajar::test {
namespace {

constexpr double PI = glm::pi<double>();
const glm::vec3 ALBEDO(0.8f, 0.5f, 0.2f);

class ExactAnswers : public RenderTest {};

class ExactAnswersByStrategy : public RenderTestByStrategy {};
INSTANTIATE_TEST_SUITE_P(Strategies, ExactAnswersByStrategy, testing::Values("bsdf", "light", "mis"),
                         [](const auto& row) { return std::string(row.param); });

// A large floor at y = 0, seen at a slant.
std::uint32_t add_floor(SceneBuilder& builder) {
    const std::uint32_t material = builder.material(lambert(ALBEDO));
    builder.square({0, 0, 0}, {0, 1, 0}, 50, material);
    builder.perspective({0, 1.2f, 3}, {0, 0, 0}, 0.7f);
    return material;
}

// Radiance of a Lambertian floor at y = 0 under an irradiance that depends on the place.
template <class Irradiance> RayRadiance floor_under(Irradiance irradiance) {
    return [=](const ViewRay& ray) -> std::optional<glm::dvec3> {
        if (ray.direction.y > -0.05) return std::nullopt; // near or above the horizon
        return glm::dvec3(ALBEDO) / PI * irradiance(meet_plane(ray, {0, 0, 0}, {0, 1, 0}));
    };
}

// Only where the ray meets the plane at that height within 2.5 m of the y axis.
RayRadiance near_axis(double height, RayRadiance radiance) {
    return [height, radiance = std::move(radiance)](const ViewRay& ray) -> std::optional<glm::dvec3> {
        const glm::dvec3 p = meet_plane(ray, {0, height, 0}, {0, 1, 0});
        const bool ahead = glm::dot(p - ray.origin, ray.direction) > 0;
        return ahead && p.x * p.x + p.z * p.z < 6.25 ? radiance(ray) : std::nullopt;
    };
}

TEST_F(ExactAnswers, APointLightOverAPlaneFallsWithTheSquareOfTheDistance) {
    SceneBuilder builder;
    add_floor(builder);
    builder.point_light({0.3f, 0.8f, 0.2f}, {2, 3, 4});
    const Scene scene = builder.build();
    const RenderSettings settings = small_settings();
    expect_radiance(render(scene, settings), scene.cameras[0], settings, floor_under([](const glm::dvec3& p) {
                        const glm::dvec3 to_light = glm::dvec3(0.3, 0.8, 0.2) - p;
                        const double distance = glm::length(to_light);
                        return glm::dvec3(2, 3, 4) * (to_light.y / distance / (distance * distance));
                    }),
                    1e-4); // the pixel's mean by 6 x 6 points
}

TEST_F(ExactAnswers, ASpotLightFadesBetweenItsCones) {
    SceneBuilder builder;
    add_floor(builder);
    builder.spot_light({0, 1, 0}, {0, -1, 0}, {5, 5, 5}, 0.2f, 0.7f);
    const Scene scene = builder.build();
    RenderSettings settings = small_settings();
    settings.samples = 256;
    const double scale = 1 / (std::cos(0.2) - std::cos(0.7)); // KHR_lights_punctual
    expect_radiance(render(scene, settings), scene.cameras[0], settings,
                    floor_under([=](const glm::dvec3& p) {
                        const glm::dvec3 to_light = glm::dvec3(0, 1, 0) - p;
                        const double distance = glm::length(to_light);
                        const double cosine = to_light.y / distance; // to the axis and to the floor's normal
                        const double fade = glm::clamp((cosine - std::cos(0.7)) * scale, 0.0, 1.0);
                        return glm::dvec3(5) * (fade * fade * cosine / (distance * distance));
                    }),
                    5e-3); // the 6 x 6 points see the cones' kinks coarsely
}

TEST_F(ExactAnswers, ADirectionalLightShadesASphereByItsCosine) {
    SceneBuilder builder;
    builder.sphere({0, 0, 0}, 1, 5, Normals::smooth, builder.material(lambert(ALBEDO)));
    builder.directional_light({-0.5f, -0.3f, -1}, {PI, PI, PI});
    builder.orthographic({0, 0, 5}, {0, 0, 0}, 1.1f);
    const Scene scene = builder.build();
    const RenderSettings settings = small_settings();
    const glm::dvec3 to_light = glm::normalize(glm::dvec3(0.5, 0.3, 1));
    expect_radiance(
        render(scene, settings), scene.cameras[0], settings,
        [=](const ViewRay& ray) -> std::optional<glm::dvec3> {
            const auto p = meet_sphere(ray, {0, 0, 0}, 1);
            if (!p) return std::nullopt;
            const double cosine = glm::dot(*p, to_light);
            if (std::abs(cosine) < 0.05) return std::nullopt; // facets turn away one by one
            return glm::dvec3(ALBEDO) * std::max(cosine, 0.0);
        },
        4e-3); // facets of 2 degrees lie up to 1.5e-4 inside: most at the outline
}

TEST_F(ExactAnswers, APointLightShadesASphereInClosedForm) {
    SceneBuilder builder;
    builder.sphere({0, 0, 0}, 1, 5, Normals::smooth, builder.material(lambert(ALBEDO)));
    builder.point_light({1, 2, 2}, {20, 20, 20});
    builder.perspective({0, 0, 5}, {0, 0, 0}, 0.4f);
    const Scene scene = builder.build();
    const RenderSettings settings = small_settings();
    expect_radiance(
        render(scene, settings), scene.cameras[0], settings,
        [=](const ViewRay& ray) -> std::optional<glm::dvec3> {
            const auto p = meet_sphere(ray, {0, 0, 0}, 1);
            if (!p) return std::nullopt;
            const glm::dvec3 to_light = glm::dvec3(1, 2, 2) - *p;
            const double distance = glm::length(to_light);
            const double cosine = glm::dot(*p, to_light) / distance;
            if (std::abs(cosine) < 0.05) return std::nullopt;
            return glm::dvec3(ALBEDO) / PI * (20 * std::max(cosine, 0.0) / (distance * distance));
        },
        4e-3);
}

TEST_P(ExactAnswersByStrategy, ASquareLightOverAPlaneFollowsLambertsFormula) {
    SceneBuilder builder;
    add_floor(builder);
    builder.square({0, 1.5f, 0}, {0, -1, 0}, 1, builder.material(emitter({4, 2, 1})));
    const Scene scene = builder.build();
    RenderSettings settings = strategy_settings();
    settings.samples = 256;
    const std::vector<glm::dvec3> corners = {{-1, 1.5, -1}, {1, 1.5, -1}, {1, 1.5, 1}, {-1, 1.5, 1}};
    const auto under = floor_under([=](const glm::dvec3& p) {
        return glm::dvec3(4, 2, 1) * polygon_irradiance(corners, p, {0, 1, 0});
    });
    expect_radiance(render(scene, settings), scene.cameras[0], settings, near_axis(0, under), 1e-4);
}

TEST_P(ExactAnswersByStrategy, AnEmitterShinesFromItsFrontOnlyUnlessDoubleSided) {
    // The ceiling above it sees the light's back.
    const std::vector<glm::dvec3> corners = {{-1, 1, -1}, {1, 1, -1}, {1, 1, 1}, {-1, 1, 1}};
    for (const bool double_sided : {false, true}) {
        SceneBuilder builder;
        Material light = emitter({4, 4, 4});
        light.double_sided = double_sided;
        builder.square({0, 1, 0}, {0, -1, 0}, 1, builder.material(light));
        builder.square({0, 2, 0}, {0, -1, 0}, 50, builder.material(lambert(ALBEDO)));
        builder.perspective({0, 1.2f, 4}, {0, 2, 0}, 0.5f);
        const Scene scene = builder.build();
        RenderSettings settings = strategy_settings();
        settings.samples = 256;
        const auto above = [=](const ViewRay& ray) -> std::optional<glm::dvec3> {
            const glm::dvec3 p = meet_plane(ray, {0, 2, 0}, {0, 1, 0});
            const double e = double_sided ? 4 * polygon_irradiance(corners, p, {0, -1, 0}) : 0;
            return glm::dvec3(ALBEDO) / PI * e;
        };
        expect_radiance(render(scene, settings), scene.cameras[0], settings, near_axis(2, above), 1e-4);
    }
}

TEST_F(ExactAnswers, TheBackOfASingleSidedEmitterIsBlack) {
    for (const bool double_sided : {false, true}) {
        SceneBuilder builder;
        Material light = emitter({1, 2, 4});
        light.double_sided = double_sided;
        builder.square({0, 0, 0}, {0, 0, -1}, 5, builder.material(light));
        builder.orthographic({0, 0, 3}, {0, 0, 0}, 1);
        const Scene scene = builder.build();
        const RenderSettings settings = small_settings();
        const glm::dvec3 seen = double_sided ? glm::dvec3(1, 2, 4) : glm::dvec3(0);
        expect_radiance(
            render(scene, settings), scene.cameras[0], settings,
            [=](const ViewRay&) { return std::optional(seen); }, 0);
    }
}

TEST_F(ExactAnswers, ABlendedSurfaceIsThereWithTheProbabilityOfItsAlpha) {
    // Seen through it: the emitter behind, less what the black veil takes.
    SceneBuilder builder;
    Material veil = lambert({0, 0, 0});
    veil.base_color.a = 0.3f;
    veil.alpha_mode = AlphaMode::blend;
    builder.square({0, 0, 1}, {0, 0, 1}, 5, builder.material(veil));
    builder.square({0, 0, 0.5f}, {0, 0, -1}, 5, builder.material(veil)); // from behind it is there too
    builder.square({0, 0, 0}, {0, 0, 1}, 5, builder.material(emitter({1, 2, 4})));
    builder.orthographic({0, 0, 3}, {0, 0, 0}, 1);
    const Scene scene = builder.build();
    RenderSettings settings = small_settings();
    settings.samples = 256;
    expect_radiance(render(scene, settings), scene.cameras[0], settings,
                    [](const ViewRay&) { return std::optional(0.7 * 0.7 * glm::dvec3(1, 2, 4)); });
}

TEST_F(ExactAnswers, ABlendedSurfaceCastsTheShadowOfItsAlpha) {
    SceneBuilder builder;
    add_floor(builder);
    Material veil = lambert({0, 0, 0});
    veil.base_color.a = 0.3f;
    veil.alpha_mode = AlphaMode::blend;
    builder.square({0, 2, 0}, {0, 1, 0}, 100, builder.material(veil));
    builder.directional_light({0.3f, -1, 0.2f}, {PI, PI, PI});
    const Scene scene = builder.build();
    RenderSettings settings = small_settings();
    settings.samples = 256;
    const double cosine = 1 / std::sqrt(1 + 0.09 + 0.04);
    expect_radiance(render(scene, settings), scene.cameras[0], settings,
                    floor_under([=](const glm::dvec3&) { return glm::dvec3(0.7 * PI * cosine); }));
}

TEST_F(ExactAnswers, AMaskedSurfaceIsThereFromItsCutoffOn) {
    for (const float alpha : {0.49f, 0.5f, 0.51f}) {
        SceneBuilder builder;
        Material mask = emitter({1, 2, 4});
        mask.base_color.a = alpha;
        mask.alpha_mode = AlphaMode::mask; // cut off below 0.5
        builder.square({0, 0, 0}, {0, 0, 1}, 5, builder.material(mask));
        builder.orthographic({0, 0, 3}, {0, 0, 0}, 1);
        const Scene scene = builder.build();
        const RenderSettings settings = small_settings();
        const glm::dvec3 seen = alpha < 0.5f ? glm::dvec3(0) : glm::dvec3(1, 2, 4);
        expect_radiance(
            render(scene, settings), scene.cameras[0], settings,
            [=](const ViewRay&) { return std::optional(seen); }, 0);
    }
}

TEST_F(ExactAnswers, DirectLightAloneLeavesReflectionsOut) {
    // White walls throw light onto the floor, but not at zero indirect bounces.
    SceneBuilder builder;
    add_floor(builder);
    builder.square({-2, 0, 0}, {1, 0, 0}, 6, builder.material(lambert({1, 1, 1})));
    builder.square({0, 0, -2}, {0, 0, 1}, 6, builder.material(lambert({1, 1, 1})));
    builder.point_light({0, 1, 0}, {1, 1, 1});
    builder.perspective({1, 2.5f, 1}, {0, 0, 0}, 0.5f);
    Scene scene = builder.build();
    scene.camera = 1;
    RenderSettings settings = small_settings();
    const auto direct = floor_under([](const glm::dvec3& p) {
        const glm::dvec3 to_light = glm::dvec3(0, 1, 0) - p;
        const double distance = glm::length(to_light);
        return glm::dvec3(1) * (1 / (distance * distance * distance));
    });
    const Image alone = render(scene, settings);
    expect_radiance(alone, scene.cameras[1], settings, direct, 1e-4);
    settings.max_bounces = 2;
    const Image reflected = render(scene, settings);
    Moments added;
    for (std::uint32_t y = 0; y < alone.height; ++y)
        for (std::uint32_t x = 0; x < alone.width; ++x)
            added.add(pixel(reflected, "", x, y).x - pixel(alone, "", x, y).x);
    EXPECT_GT(added.mean(), 5 * added.standard_error())
        << "the walls reflect nothing: there was nothing to leave out";
}

} // namespace
} // namespace ajar::test
