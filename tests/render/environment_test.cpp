// Environment maps: where a direction looks, and what they bring to a surface. Maps linear in the direction,
// whose integrals are known, so the map's orientation and rotation are under test too.
#include "base/error.hpp"
#include "render/render.hpp"
#include "render_test.hpp"

#include <glm/gtc/constants.hpp>

namespace ajar::test {
namespace {

constexpr double PI = glm::pi<double>();
// Fine enough that bilinear interpolation is off by less than (2 pi / 256)^2 / 8 of the slope.
constexpr std::uint32_t WIDTH = 256;
constexpr std::uint32_t HEIGHT = 128;
constexpr double INTERPOLATION = 1e-4;

const glm::dvec3 SLOPE_R(0.6, 0, 0);
const glm::dvec3 SLOPE_G(0, 0.6, 0);
const glm::dvec3 SLOPE_B(0.3, 0.2, 0.4);

// 1 + slope . d, a slope per channel.
glm::dvec3 sloped(const glm::dvec3& d) {
    return {1 + glm::dot(SLOPE_R, d), 1 + glm::dot(SLOPE_G, d), 1 + glm::dot(SLOPE_B, d)};
}

// What a Lambertian of that normal reflects under `sloped`: the integral of (1 + s . d) (n . d) over the
// hemisphere is pi + 2 pi / 3 (s . n); divided by pi.
glm::dvec3 reflected(const glm::dvec3& n) {
    return {1 + 2.0 / 3 * glm::dot(SLOPE_R, n), 1 + 2.0 / 3 * glm::dot(SLOPE_G, n),
            1 + 2.0 / 3 * glm::dot(SLOPE_B, n)};
}

// Turned about +Y by `angle`: +Z goes to +X at a right angle.
glm::dvec3 turned(const glm::dvec3& d, double angle) {
    return {std::cos(angle) * d.x + std::sin(angle) * d.z, d.y,
            std::cos(angle) * d.z - std::sin(angle) * d.x};
}

Scene with_map(SceneBuilder& builder, float rotation) {
    builder.environment_map(WIDTH, HEIGHT, [](const glm::vec3& d) { return glm::vec3(sloped(d)); });
    Scene scene = builder.build();
    scene.environment->rotation = rotation;
    return scene;
}

class EnvironmentMap : public RenderTest {};

TEST_F(EnvironmentMap, IsSeenWhereItsLayoutPutsIt) {
    for (const float rotation : {0.0f, 1.0f}) {
        SceneBuilder builder;
        builder.square({0, -100, 0}, {0, 1, 0}, 0.01f, builder.material(lambert({0, 0, 0})));
        builder.perspective({0, 0, 0}, {1, 0.5f, 2}, 1.2f);
        const Scene scene = with_map(builder, rotation);
        const RenderSettings settings = small_settings();
        expect_radiance(
            render(scene, settings), scene.cameras[0], settings,
            [=](const ViewRay& ray) { return std::optional(sloped(turned(ray.direction, -rotation))); },
            INTERPOLATION);
    }
}

// A strategy, and how a direction to the map is picked.
struct Method {
    const char* strategy;
    std::string sampling = "auto";
    void set(RenderSettings& settings) const {
        settings.strategy = strategy;
        settings.environment_sampling = sampling;
    }
    std::string name() const { return strategy + (", " + sampling); }
};

std::vector<Method> methods() {
    std::vector<Method> all{{"bsdf"}, {"light"}};
    for (const Choice& row : environment_samplings()) all.push_back({"mis", row.name});
    return all;
}

TEST_F(EnvironmentMap, LightsASurfaceByItsIntegral) {
    for (const Method& method : methods())
        for (const float rotation : {0.0f, 2.5f}) {
            SceneBuilder builder;
            builder.square({0, 0, 0}, {1, 0, 0}, 10, builder.material(lambert({1, 1, 1})));
            builder.orthographic({5, 0, 0}, {0, 0, 0}, 1);
            const Scene scene = with_map(builder, rotation);
            RenderSettings settings = small_settings();
            method.set(settings);
            settings.samples = 256;
            SCOPED_TRACE(testing::Message() << method.name() << ", turned by " << rotation);
            const glm::dvec3 right = reflected(turned({1, 0, 0}, -rotation));
            expect_radiance(
                render(scene, settings), scene.cameras[0], settings,
                [=](const ViewRay&) { return std::optional(right); }, INTERPOLATION);
        }
}

// Of a map that is the same all around: there is nothing above its mean.
TEST_F(EnvironmentMap, OfOneColourLightsASurfaceByThatColour) {
    for (const Method& method : methods()) {
        SceneBuilder builder;
        builder.square({0, 0, 0}, {1, 0, 0}, 10, builder.material(lambert({1, 1, 1})));
        builder.orthographic({5, 0, 0}, {0, 0, 0}, 1);
        builder.environment_map(32, 16, [](const glm::vec3&) { return glm::vec3(0.25f, 0.5f, 1); });
        const Scene scene = builder.build();
        RenderSettings settings = small_settings();
        method.set(settings);
        settings.samples = 256;
        SCOPED_TRACE(method.name());
        expect_radiance(
            render(scene, settings), scene.cameras[0], settings,
            [](const ViewRay&) { return std::optional(glm::dvec3(0.25, 0.5, 1)); }, 1e-5);
    }
}

TEST_F(EnvironmentMap, ASmallSunIsFoundByImportance) {
    // One texel shines on a dark sky. Bilinear interpolation spreads its light over the four quarters around
    // it, as a tent two texels wide whose integral over the map is one texel; solid angle differs from row to
    // row by its sine.
    SceneBuilder builder;
    builder.square({0, 0, 0}, {0, 1, 0}, 10, builder.material(lambert({1, 1, 1})));
    builder.orthographic({0, 3, 0}, {0, 0, 0}, 1);
    constexpr std::uint32_t COLUMN = 40;
    constexpr std::uint32_t ROW = 21;
    const glm::vec3 sun = environment_direction(COLUMN, ROW, WIDTH, HEIGHT);
    builder.environment_map(WIDTH, HEIGHT,
                            [&](const glm::vec3& d) { return glm::vec3(d == sun ? 1000.0f : 0.0f); });
    const Scene scene = builder.build();
    double irradiance = 0; // integral of tent(theta) cos sin, times the tent's integral in phi
    constexpr int STEPS = 2000;
    const double step = PI / HEIGHT;
    for (int k = 0; k < STEPS; ++k) {
        const double offset = 2 * (k + 0.5) / STEPS - 1; // rows from the texel's middle
        const double theta = (ROW + 0.5 + offset) * step;
        irradiance += (1 - std::abs(offset)) * std::cos(theta) * std::sin(theta) * step * 2 / STEPS;
    }
    irradiance *= 1000 * 2 * PI / WIDTH;
    for (const Method& method : methods()) {
        if (method.strategy == std::string("bsdf")) continue; // finds it a few times in a hundred thousand
        RenderSettings settings = small_settings();
        method.set(settings);
        settings.samples = 256;
        SCOPED_TRACE(method.name());
        expect_radiance(
            render(scene, settings), scene.cameras[0], settings,
            [=](const ViewRay&) { return std::optional(glm::dvec3(irradiance / PI)); }, 1e-4);
    }
}

// What light sampling alone leaves out would be missing; with both it is not.
TEST_F(EnvironmentMap, IsNotSampledByItsExcessWhereNothingFindsTheRest) {
    SceneBuilder builder;
    builder.square({0, 0, 0}, {0, 1, 0}, 10, builder.material(lambert({1, 1, 1})));
    builder.orthographic({0, 3, 0}, {0, 0, 0}, 1);
    const Scene scene = with_map(builder, 0);
    RenderSettings settings = small_settings();
    settings.strategy = "light";
    settings.environment_sampling = "compensated";
    EXPECT_THROW(render(scene, settings), Error);
    settings.environment_sampling = "nonsense";
    EXPECT_THROW(render(scene, settings), Error);
    const auto pixels = [&](const char* strategy, const char* sampling) {
        settings.strategy = strategy;
        settings.environment_sampling = sampling;
        return beauty(render(scene, settings), strategy).pixels;
    };
    EXPECT_EQ(pixels("light", "auto"), pixels("light", "radiance"));
    EXPECT_EQ(pixels("bsdf", "compensated"), pixels("bsdf", "radiance")) << "no light is sampled";
    EXPECT_EQ(pixels("mis", "auto"), pixels("mis", "compensated"));
    EXPECT_NE(pixels("mis", "radiance"), pixels("mis", "compensated"));
}

TEST_F(EnvironmentMap, TheBackgroundColourIsAConstantEnvironment) {
    SceneBuilder builder;
    builder.square({0, 0, 0}, {0, 1, 0}, 10, builder.material(lambert({0.5f, 0.5f, 0.5f})));
    builder.orthographic({0, 3, 0}, {0, 0, 0}, 1);
    RenderSettings settings = small_settings();
    settings.background[0] = 1;
    settings.background[1] = 2;
    settings.background[2] = 4;
    const Scene scene = builder.build();
    expect_radiance(render(scene, settings), scene.cameras[0], settings,
                    [](const ViewRay&) { return std::optional(0.5 * glm::dvec3(1, 2, 4)); });
}

} // namespace
} // namespace ajar::test
