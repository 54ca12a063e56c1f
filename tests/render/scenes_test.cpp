// The scenes of scenes/ from file to image: the right answers that their READMEs state.
#include "import/import.hpp"
#include "render_test.hpp"

#include <filesystem>

namespace ajar::test {
namespace {

class Scenes : public RenderTest {
  protected:
    static Scene load(const std::string& name) {
        const auto folder = std::filesystem::path(AJAR_SOURCE_DIR) / "scenes" / name;
        ImportResult result = import_gltf(folder / (name + ".gltf"));
        for (const std::string& warning : result.info.warnings) ADD_FAILURE() << name << ": " << warning;
        if (std::filesystem::exists(folder / "sky.hdr"))
            result.scene.environment = import_environment(folder / "sky.hdr");
        return std::move(result.scene);
    }
    static RenderSettings settings() {
        RenderSettings settings = small_settings();
        settings.width = settings.height = 64;
        return settings;
    }
};

TEST_F(Scenes, AllImportAndRender) {
    for (const auto& entry : std::filesystem::directory_iterator(std::string(AJAR_SOURCE_DIR) + "/scenes")) {
        const std::string name = entry.path().filename().string();
        if (!entry.is_directory() || name.starts_with("_")) continue;
        SCOPED_TRACE(name);
        RenderSettings settings = Scenes::settings();
        settings.samples = 4;
        settings.max_bounces = 3;
        const Image image = render(load(name), settings);
        double sum = 0;
        for (const float value : beauty(image, name).pixels) sum += value;
        EXPECT_GT(sum, 0.01 * static_cast<double>(image.pixel_count())) << "(nearly) black";
    }
}

TEST_F(Scenes, TheFurnaceRoomIsItsGeometricSeries) {
    const Scene scene = load("furnace-room");
    RenderSettings settings = Scenes::settings();
    settings.max_bounces = 3;
    settings.strategy = "bsdf";
    glm::dvec3 sum(0);
    for (int k = 0; k <= 4; ++k) sum += glm::pow(glm::dvec3(0.25, 0.5, 0.8), glm::dvec3(k));
    expect_radiance(render(scene, settings), scene.cameras[0], settings,
                    [=](const ViewRay&) { return std::optional(sum); });
}

TEST_F(Scenes, TheCornellBoxHasItsLightInTheCeilingAndADarkCeilingAroundIt) {
    const Scene scene = load("cornell-box");
    RenderSettings settings = Scenes::settings();
    const Image direct = render(scene, settings);
    settings.max_bounces = 4;
    const Image reflected = render(scene, settings);
    // The middle of the light is seen at tan 0.2555 of tan 0.3571 above the axis: row 9. Before it, ceiling.
    for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(pixel(direct, "", 32, 9)[c], glm::dvec3(17, 12, 4)[c], 1e-4);
        EXPECT_EQ(pixel(direct, "", 32, 4)[c], 0);
        EXPECT_GT(pixel(reflected, "", 32, 4)[c], 0);
    }
    // The red wall is on the left, the green one on the right.
    const glm::dvec3 left = pixel(reflected, "", 4, 32);
    const glm::dvec3 right = pixel(reflected, "", 59, 32);
    EXPECT_GT(left.r, 2 * left.g);
    EXPECT_GT(right.g, 2 * right.b);
}

TEST_F(Scenes, TheSkyLightsThePlaneByItsIntegral) {
    // At the lower edge of the picture, 2 m before the spheres, which hide less than 3 % of the sky.
    RenderSettings settings = Scenes::settings();
    settings.samples = 1024;
    const Image image = render(load("environment-only"), settings);
    const glm::dvec3 open(0.4893, 0.5228, 0.6312); // scenes/environment-only/README.md
    for (int c = 0; c < 3; ++c) {
        double mean = 0;
        double variance = 0;
        for (std::uint32_t x = 0; x < 64; ++x) {
            mean += pixel(image, "", x, 63)[c] / 64;
            variance += pixel(image, "variance", x, 63)[c] / (64 * 64);
        }
        EXPECT_GT(mean, 0.97 * open[c] - 4 * std::sqrt(variance));
        EXPECT_LT(mean, open[c] + 4 * std::sqrt(variance));
    }
}

TEST_F(Scenes, TheCheckersGreysAreDecoded) {
    RenderSettings settings = Scenes::settings();
    settings.integrator = "albedo";
    const Image image = render(load("textured"), settings);
    double lightest = 0;
    double darkest = 1;
    for (std::uint32_t x = 24; x < 40; ++x) {
        lightest = std::max(lightest, pixel(image, "", x, 62).g);
        darkest = std::min(darkest, pixel(image, "", x, 62).g);
    }
    EXPECT_NEAR(lightest, 0.5029, 2e-4); // sRGB 188
    EXPECT_NEAR(darkest, 0.1248, 2e-4);  // sRGB 99
}

} // namespace
} // namespace ajar::test
