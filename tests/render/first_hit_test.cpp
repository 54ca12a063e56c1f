// Where the camera looks and what it sees there: pixel-exact geometry, and the integrators of first hits.
#include "base/error.hpp"
#include "render_test.hpp"

#include <glm/gtc/constants.hpp>

namespace ajar::test {
namespace {

class FirstHit : public RenderTest {};

// A glowing rectangle in the plane z = 0.
SceneBuilder rectangle(glm::vec2 lower, glm::vec2 upper) {
    SceneBuilder builder;
    builder.quad({lower.x, lower.y, 0}, {upper.x, lower.y, 0}, {upper.x, upper.y, 0}, {lower.x, upper.y, 0},
                 builder.material(emitter({1, 2, 4})));
    return builder;
}

// Expects the emission in columns [8, 20) and rows [4, 24), and nothing elsewhere.
void expect_rectangle(const Image& image) {
    for (std::uint32_t y = 0; y < image.height; ++y)
        for (std::uint32_t x = 0; x < image.width; ++x) {
            const bool inside = x >= 8 && x < 20 && y >= 4 && y < 24;
            EXPECT_EQ(pixel(image, "", x, y), inside ? glm::dvec3(1, 2, 4) : glm::dvec3(0)) << x << ", " << y;
        }
}

TEST_F(FirstHit, AnOrthographicCameraCoversItsMagnification) {
    // 32 rows over 2 m: a pixel is a sixteenth. Column x lies at x / 16 - 1, row y at 1 - y / 16.
    SceneBuilder builder = rectangle({-0.5f, -0.5f}, {0.25f, 0.75f});
    builder.orthographic({0, 0, 3}, {0, 0, 0}, 1);
    expect_rectangle(render(builder.build(), small_settings()));
}

TEST_F(FirstHit, APerspectiveCameraCoversItsVerticalAngle) {
    SceneBuilder builder = rectangle({-1.5f, -1.5f}, {0.75f, 2.25f});
    builder.perspective({0, 0, 3}, {0, 0, 0}, glm::half_pi<float>()); // 90 degrees: 6 m at 3 m
    expect_rectangle(render(builder.build(), small_settings()));
}

TEST_F(FirstHit, TheVerticalAngleHoldsWhateverTheAspect) {
    RenderSettings settings = small_settings();
    settings.width = 64; // 12 m at 3 m
    SceneBuilder builder = rectangle({-4.5f, -1.5f}, {-2.25f, 2.25f});
    builder.perspective({0, 0, 3}, {0, 0, 0}, glm::half_pi<float>());
    const Image image = render(builder.build(), settings);
    EXPECT_EQ(image.width, 64u);
    expect_rectangle(image);
}

TEST_F(FirstHit, AChosenCameraIsTakenByNameOrIndex) {
    SceneBuilder builder = rectangle({-0.5f, -0.5f}, {0.25f, 0.75f});
    builder.orthographic({0, 0, 3}, {0, 0, 5}, 1); // looks away
    builder.orthographic({0, 0, 3}, {0, 0, 0}, 1);
    Scene scene = builder.build();
    scene.cameras[0].name = "away";
    scene.cameras[1].name = "front";
    RenderSettings settings = small_settings();
    for (const char* choice : {"front", "1"}) {
        settings.camera = choice;
        expect_rectangle(render(scene, settings));
    }
    settings.camera = "away";
    EXPECT_EQ(pixel(render(scene, settings), "", 10, 10), glm::dvec3(0));
    settings.camera = "behind";
    EXPECT_THROW(Renderer(device(), scene, {}).render(settings), Error);
}

TEST_F(FirstHit, TheFilmAveragesWhatAPixelSees) {
    // The rectangle's edges run through the middle of pixels: half their light, a quarter at the corner.
    SceneBuilder builder = rectangle({-0.5f + 1.0f / 32, -0.5f}, {0.25f, 0.75f - 1.0f / 32});
    builder.orthographic({0, 0, 3}, {0, 0, 0}, 1);
    RenderSettings settings = small_settings();
    settings.samples = 256; // stratified: exact in elementary halves
    const Image image = render(builder.build(), settings);
    EXPECT_EQ(pixel(image, "", 8, 10), 0.5 * glm::dvec3(1, 2, 4));
    EXPECT_EQ(pixel(image, "", 12, 4), 0.5 * glm::dvec3(1, 2, 4));
    EXPECT_EQ(pixel(image, "", 8, 4), 0.25 * glm::dvec3(1, 2, 4));
    // Samples of 0 and 1 in equal number: variance of the mean is n / 4 / (n (n - 1)).
    EXPECT_NEAR(pixel(image, "variance", 8, 10).x, 0.25 / 255, 1e-9);
}

TEST_F(FirstHit, TheNormalsIntegratorShowsASpheresNormals) {
    SceneBuilder builder;
    builder.sphere({0, 0, 0}, 1, 5, Normals::smooth, builder.material(lambert({1, 1, 1})));
    builder.orthographic({0, 0, 5}, {0, 0, 0}, 1.2f);
    const Scene scene = builder.build();
    RenderSettings settings = small_settings();
    settings.integrator = "normals";
    expect_radiance(
        render(scene, settings), scene.cameras[0], settings,
        [](const ViewRay& ray) -> std::optional<glm::dvec3> {
            const auto p = meet_sphere(ray, {0, 0, 0}, 1);
            return p ? std::optional(0.5 * *p + 0.5) : std::nullopt;
        },
        3e-3); // facets of 2 degrees, 16-bit normals, and the 6 x 6 points of a pixel's mean
}

TEST_F(FirstHit, TheAlbedoIntegratorShowsReflectanceAndDecodesTextures) {
    SceneBuilder builder;
    const std::vector<std::uint8_t> greys = {188, 188, 188, 255, 99,  99,  99,  255,
                                             99,  99,  99,  255, 188, 188, 188, 255};
    Material checker = lambert({1, 0.5f, 0.25f});
    checker.base_color_texture.texture = builder.texture(2, 2, greys, TextureFilter::nearest);
    builder.square({0, 0, 0}, {0, 0, 1}, 1, builder.material(checker));
    builder.orthographic({0, 0, 3}, {0, 0, 0}, 1);
    const Scene scene = builder.build();
    RenderSettings settings = small_settings();
    settings.integrator = "albedo";
    const auto linear = [](double byte) {
        return std::pow((byte / 255 + 0.055) / 1.055, 2.4);
    }; // IEC 61966-2-1
    expect_radiance(
        render(scene, settings), scene.cameras[0], settings,
        [=](const ViewRay& ray) -> std::optional<glm::dvec3> {
            const glm::dvec3 p = meet_plane(ray, {0, 0, 0}, {0, 0, 1});
            const bool light = (p.x < 0) == (p.y < 0);
            // Image row 0 is at v = 0, which the square has at its lower edge.
            return glm::dvec3(1, 0.5, 0.25) * linear(light ? 188 : 99);
        },
        1e-4);
}

TEST_F(FirstHit, ThereIsNoAmbientOcclusionInTheOpen) {
    SceneBuilder builder;
    builder.square({0, 0, 0}, {0, 1, 0}, 50, builder.material(lambert({0, 0, 0})));
    builder.orthographic({0, 3, 0}, {0, 0, 0}, 1);
    RenderSettings settings = small_settings();
    settings.integrator = "ao";
    const Image image = render(builder.build(), settings);
    for (std::uint32_t y = 0; y < image.height; ++y)
        for (std::uint32_t x = 0; x < image.width; ++x)
            EXPECT_EQ(pixel(image, "", x, y), glm::dvec3(1)) << x << ", " << y;
}

TEST_F(FirstHit, AmbientOcclusionBesideAWallIsItsFormFactor) {
    // A wall of height h, endless to both sides, takes (1 - x / sqrt(x^2 + h^2)) / 2 of a floor point's sky.
    SceneBuilder builder;
    const std::uint32_t white = builder.material(lambert({1, 1, 1}));
    builder.quad({0, 0, 500}, {50, 0, 500}, {50, 0, -500}, {0, 0, -500}, white);
    builder.quad({0, 0, 500}, {0, 0, -500}, {0, 2, -500}, {0, 2, 500}, white);
    builder.orthographic({1.25f, 5, 0}, {1.25f, 0, 0}, 1);
    const Scene scene = builder.build();
    RenderSettings settings = small_settings();
    settings.integrator = "ao";
    settings.ao_distance = 5000;
    settings.samples = 256;
    expect_radiance(
        render(scene, settings), scene.cameras[0], settings,
        [](const ViewRay& ray) -> std::optional<glm::dvec3> {
            const double x = ray.origin.x;
            return glm::dvec3(0.5 + 0.5 * x / std::sqrt(x * x + 4));
        },
        1e-4); // the wall ends after 500 m
}

TEST_F(FirstHit, AmbientOcclusionLooksNoFartherThanItsDistance) {
    SceneBuilder builder;
    const std::uint32_t white = builder.material(lambert({1, 1, 1}));
    builder.square({0, 0, 0}, {0, 1, 0}, 50, white);
    builder.square({0, 2, 0}, {0, -1, 0}, 50, white);
    builder.perspective({0, 1, 0}, {0, 0, 0}, 0.5f);
    const Scene scene = builder.build();
    RenderSettings settings = small_settings();
    settings.integrator = "ao";
    settings.ao_distance = 1.9f;
    EXPECT_EQ(pixel(render(scene, settings), "", 16, 16), glm::dvec3(1));
    // At twice the height, directions within 60 degrees of the normal meet the ceiling: sin^2 60 of all.
    settings.ao_distance = 4;
    settings.samples = 256;
    expect_radiance(
        render(scene, settings), scene.cameras[0], settings,
        [](const ViewRay&) { return std::optional(glm::dvec3(0.25)); }, 1e-4);
}

} // namespace
} // namespace ajar::test
