// The scenes of scenes/ from file to image: the right answers that their READMEs state.
#include "import/import.hpp"
#include "render_test.hpp"

#include <filesystem>
#include <fstream>
#include <glm/ext/matrix_transform.hpp>
#include <glm/gtc/constants.hpp>
#include <iterator>
#include <regex>
#include <set>

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
    static std::string readme(const std::string& name) {
        std::ifstream file(std::filesystem::path(AJAR_SOURCE_DIR) / "scenes" / name / "README.md");
        return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
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

TEST_F(Scenes, TheMirrorInTheFurnaceRoomCannotBeSeen) {
    const Scene scene = load("furnace-room-mirror");
    RenderSettings settings = Scenes::settings();
    settings.max_bounces = 30;
    for (const char* strategy : {"bsdf", "mis"}) {
        SCOPED_TRACE(strategy);
        settings.strategy = strategy;
        expect_radiance(render(scene, settings), scene.cameras[0], settings, [](const ViewRay&) {
            return std::optional(1.0 / (1.0 - glm::dvec3(0.2, 0.35, 0.5)));
        });
    }
}

// Emissive triangles within half a square's width of the camera's street, and all.
struct LightCount {
    std::size_t street = 0;
    std::size_t all = 0;
};

LightCount count_lights(const Scene& scene) {
    LightCount count;
    const float street =
        std::round((scene.cameras[0].to_world[3].x - 0.3f) / 3) * 3; // the camera is 0.3 aside
    for (const Instance& instance : scene.instances) {
        const Mesh& mesh = scene.meshes[instance.mesh];
        std::size_t lights = 0;
        for (const std::uint32_t material : mesh.triangle_materials)
            lights += scene.materials[material].emission != glm::vec3(0);
        count.all += lights;
        if (std::abs(instance.to_world[3].x - street) < 0.01f) count.street += lights;
    }
    return count;
}

TEST_F(Scenes, TheMarketsHaveTheLightsThatTheirNamesSay) {
    for (const std::size_t lights : {100u, 10'000u, 100'000u})
        EXPECT_EQ(count_lights(load("many-lights-" + std::to_string(lights))).all, lights);
    for (const std::size_t lights : {10'000u, 100'000u}) {
        const LightCount count = count_lights(load("many-lights-walled-" + std::to_string(lights)));
        EXPECT_EQ(count.all, lights);
        EXPECT_LE(10 * count.street, count.all);
        EXPECT_GT(count.street, 0u);
    }
}

TEST_F(Scenes, NoLightComesThroughTheMarketsWalls) {
    for (const char* name : {"many-lights-walled-10000", "many-lights-walled-100000"}) {
        SCOPED_TRACE(name);
        Scene scene = load(name);
        for (Material& material : scene.materials) // the lamps of the camera's street are put out
            if (!material.name.ends_with("_hidden")) material.emission = glm::vec3(0);
        RenderSettings settings = Scenes::settings();
        settings.samples = 16;
        settings.max_bounces = 3;
        const RenderOutput output = render_checked(device(), scene, settings);
        EXPECT_GT(output.stats.shadow_rays, 0u);
        EXPECT_EQ(output.stats.shadow_rays_open, 0u);
        for (std::uint32_t y = 0; y < settings.height; ++y)
            for (std::uint32_t x = 0; x < settings.width; ++x)
                ASSERT_EQ(pixel(output.image, "", x, y), glm::dvec3(0)) << x << ", " << y;
    }
}

TEST_F(Scenes, TheRoomBehindTheAjarDoorIsDarkWithoutBounces) {
    const Scene scene = load("ajar-door");
    RenderSettings settings = Scenes::settings();
    const auto lit = [&](const RenderOutput& output) {
        std::size_t count = 0;
        for (std::uint32_t y = 0; y < settings.height; ++y)
            for (std::uint32_t x = 0; x < settings.width; ++x)
                count += pixel(output.image, "", x, y) != glm::dvec3(0);
        return static_cast<double>(count) / static_cast<double>(output.image.pixel_count());
    };
    EXPECT_LT(lit(render_checked(device(), scene, settings)), 0.1);
    settings.max_bounces = 4;
    const RenderOutput output = render_checked(device(), scene, settings);
    EXPECT_GT(lit(output), 0.5);
    EXPECT_LT(10 * output.stats.shadow_rays_open, output.stats.shadow_rays);
}

TEST_F(Scenes, EachOfVeachsPlatesHasItsRows) {
    const Scene scene = load("veach-mis");
    const std::string text = readme("veach-mis");
    RenderSettings settings = Scenes::settings();
    settings.width = 160;
    settings.height = 90;
    settings.samples = 1;
    settings.aovs = true;
    const Image image = render(scene, settings);
    const Layer* ids = image.find("material_id");
    ASSERT_NE(ids, nullptr);
    std::set<float> plates;
    static const std::regex rows(R"re((0\.\d+) to (0\.\d+))re");
    for (std::sregex_iterator match(text.begin(), text.end(), rows), end; match != end; ++match) {
        const auto first = static_cast<std::uint32_t>(std::ceil(90 * std::stod((*match)[1])));
        const auto last = static_cast<std::uint32_t>(std::floor(90 * std::stod((*match)[2])));
        const float material = ids->pixels[std::size_t{first} * 160 + 40];
        for (std::uint32_t y = first; y < last; ++y)
            for (std::uint32_t x = 40; x < 120; ++x)
                ASSERT_EQ(ids->pixels[std::size_t{y} * 160 + x], material) << x << ", " << y;
        EXPECT_TRUE(scene.materials.at(static_cast<std::size_t>(material) - 1).name.starts_with("plate_"));
        plates.insert(material);
    }
    EXPECT_EQ(plates.size(), 4u);
}

// Of everything in the scene but its spot light, none hidden: a sphere wholly above the horizon gives the
// irradiance of a point of the same intensity.
glm::dvec3 irradiance_from_spheres(const Scene& scene, const glm::dvec3& point) {
    glm::dvec3 sum(0);
    const auto add = [&](const glm::dvec3& center, const glm::dvec3& intensity) {
        const glm::dvec3 to = center - point;
        sum += intensity * to.y / std::pow(glm::length(to), 3.0);
    };
    for (const Light& light : scene.lights) {
        if (light.kind == LightKind::point) add(light.position, light.intensity);
        if (light.kind == LightKind::directional)
            sum += glm::dvec3(light.intensity) * -static_cast<double>(light.direction.y);
    }
    for (const Instance& instance : scene.instances) {
        const Material& material = scene.materials[scene.meshes[instance.mesh].triangle_materials.front()];
        const double radius = glm::length(glm::dvec3(instance.to_world[0]));
        add(instance.to_world[3], glm::pi<double>() * radius * radius * glm::dvec3(material.emission));
    }
    return sum;
}

TEST_F(Scenes, SphereLightsLightTheTileByTheClosedForm) {
    Scene scene = load("sphere-lights");
    scene.cameras[0].to_world =
        glm::inverse(glm::lookAt(glm::vec3(0.2f, 1, 2.4f), glm::vec3(0.2f, 0.02f, 2), glm::vec3(0, 1, 0)));
    scene.cameras[0].yfov = 0.35f;
    RenderSettings settings = small_settings();
    settings.samples = 256;
    const auto tile = [&](const glm::dvec3& p) {
        return 0.8 / glm::pi<double>() * irradiance_from_spheres(scene, p);
    };
    const glm::dvec3 middle = tile({0.2, 0.02, 2});
    for (int c = 0; c < 3; ++c) // scenes/sphere-lights/README.md
        EXPECT_NEAR(middle[c], glm::dvec3(0.3198, 0.2476, 0.2625)[c], 1e-4);
    // A globe of 1,280 triangles covers up to 1 % less than its sphere.
    expect_radiance(
        render(scene, settings), scene.cameras[0], settings,
        [&](const ViewRay& ray) -> std::optional<glm::dvec3> {
            return tile(meet_plane(ray, {0, 0.02, 0}, {0, 1, 0}));
        },
        0.01);
}

} // namespace
} // namespace ajar::test
