// White furnaces: where light is the same from everywhere, reflection is a product of albedos, and any energy
// lost or made shows in every pixel.
#include "render_test.hpp"

namespace ajar::test {
namespace {

const glm::vec3 ALBEDO(0.8f, 0.5f, 0.2f);

class Furnace : public RenderTest {};

class FurnaceByStrategy : public RenderTestByStrategy {};
INSTANTIATE_TEST_SUITE_P(Strategies, FurnaceByStrategy, testing::Values("bsdf", "light", "mis"),
                         [](const auto& row) { return std::string(row.param); });

TEST_P(FurnaceByStrategy, AConvexLambertianBodyReturnsItsAlbedo) {
    SceneBuilder builder;
    builder.sphere({0, 0, 0}, 1, 3, Normals::flat, builder.material(lambert(ALBEDO)));
    builder.constant_environment({1, 0.5f, 2});
    builder.orthographic({0, 0, 5}, {0, 0, 0}, 1.1f);
    const Scene scene = builder.build();
    for (const std::uint32_t bounces : {0u, 4u}) {
        RenderSettings settings = strategy_settings();
        settings.max_bounces = bounces; // light that left a convex body is gone
        expect_radiance(render(scene, settings), scene.cameras[0], settings,
                        [](const ViewRay& ray) -> std::optional<glm::dvec3> {
                            if (!meet_sphere(ray, {0, 0, 0}, 0.98))
                                return std::nullopt; // its facets' own outline
                            return glm::dvec3(ALBEDO) * glm::dvec3(1, 0.5, 2);
                        });
    }
}

TEST_F(Furnace, BsdfSamplingOfALambertianBodyHasNoVariance) {
    // f cos / pdf is the albedo whatever the direction, so a single sample is right. A ray that wrongly met
    // the body again would show.
    SceneBuilder builder;
    builder.sphere({0, 0, 0}, 1, 3, Normals::flat, builder.material(lambert(ALBEDO)));
    builder.constant_environment({1, 1, 1});
    builder.orthographic({0, 0, 5}, {0, 0, 0}, 0.6f); // the body fills the picture
    RenderSettings settings = small_settings();
    settings.width = settings.height = 128;
    settings.strategy = "bsdf";
    const Image image = render(builder.build(), settings);
    for (std::uint32_t y = 0; y < image.height; ++y)
        for (std::uint32_t x = 0; x < image.width; ++x)
            for (int c = 0; c < 3; ++c)
                ASSERT_NEAR(pixel(image, "", x, y)[c], ALBEDO[c], 1e-6) << x << ", " << y;
}

TEST_P(FurnaceByStrategy, ARoomSumsItsAlbedosPowers) {
    // Every wall emits e and reflects a: after n indirect bounces, e times the sum of a^k for k = 0 .. n + 1.
    SceneBuilder builder;
    const glm::dvec3 a(0.25, 0.5, 0.8);
    const glm::dvec3 e(1, 0.5, 2);
    builder.room({-1, -1, -1}, {1, 1, 1}, builder.material(glowing_lambert(a, e)));
    builder.perspective({0.2f, 0.1f, 0.7f}, {-0.3f, -0.2f, -1}, 1);
    const Scene scene = builder.build();
    for (const std::uint32_t bounces : {0u, 1u, 4u, 12u}) {
        RenderSettings settings = strategy_settings();
        settings.max_bounces = bounces;
        settings.samples = 128;
        glm::dvec3 sum(0);
        for (std::uint32_t k = 0; k <= bounces + 1; ++k) sum += glm::pow(a, glm::dvec3(k));
        expect_radiance(render(scene, settings), scene.cameras[0], settings,
                        [=](const ViewRay&) { return std::optional(e * sum); });
    }
}

TEST_F(Furnace, ARoomWithoutRouletteHasNoVariance) {
    // Every path is worth the same, unless one of them slips through an edge of the closed room.
    SceneBuilder builder;
    builder.room({-1, -1, -1}, {1, 1, 1}, builder.material(glowing_lambert({0.5f, 0.5f, 0.5f}, {1, 1, 1})));
    builder.perspective({0.2f, 0.1f, 0.7f}, {-0.3f, -0.2f, -1}, 1);
    RenderSettings settings = small_settings();
    settings.strategy = "bsdf";
    settings.max_bounces = 6;
    settings.rr_depth = 100;
    settings.width = settings.height = 64;
    const Image image = render(builder.build(), settings);
    const double right = 2 - std::pow(0.5, 7);
    for (std::uint32_t y = 0; y < image.height; ++y)
        for (std::uint32_t x = 0; x < image.width; ++x)
            ASSERT_NEAR(pixel(image, "", x, y).x, right, 4e-6) << x << ", " << y;
}

} // namespace
} // namespace ajar::test
