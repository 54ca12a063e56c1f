// Paths that begin on surfaces: the irradiance of elements where it has a closed form.
#include "element_test.hpp"

#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

namespace ajar::test {
namespace {

constexpr double PI = glm::pi<double>();

struct Way {
    const char* name;
    void (*choose)(RenderSettings&);
};
void PrintTo(const Way& way, std::ostream* out) { *out << way.name; }

class IrradianceByWay : public Irradiance, public testing::WithParamInterface<Way> {};
INSTANTIATE_TEST_SUITE_P(
    Ways, IrradianceByWay,
    testing::Values(Way{"mis", [](RenderSettings&) {}},
                    Way{"light", [](RenderSettings& s) { s.strategy = "light"; }},
                    Way{"bsdf", [](RenderSettings& s) { s.strategy = "bsdf"; }},
                    Way{"all_lights", [](RenderSettings& s) { s.light_rays = "all"; }},
                    Way{"tree", [](RenderSettings& s) { s.light_sampler = "tree"; }},
                    Way{"visibility", [](RenderSettings& s) { s.light_sampler = "visibility"; }},
                    Way{"independent", [](RenderSettings& s) { s.sampler = "independent"; }}),
    [](const auto& row) { return std::string(row.param.name); });

TEST_P(IrradianceByWay, UnderASquareLightFollowsLambertsFormula) {
    const Scene scene = under_a_square_light();
    RenderSettings settings = element_settings();
    GetParam().choose(settings);
    expect_irradiance(scene, pieces(scene, 0, 6), settings, of_the_square_light, 2e-4); // 12 x 12 points
}

TEST_P(IrradianceByWay, InAFurnaceSumsTheAlbedosPowers) {
    // Every wall emits e and reflects a: after n bounces, pi e times the sum of a^k for k = 0 .. n.
    const glm::dvec3 a(0.25, 0.5, 0.8);
    const glm::dvec3 e(1, 0.5, 2);
    SceneBuilder builder;
    builder.room({-1, -1, -1}, {1, 1, 1}, builder.material(glowing_lambert(a, e)));
    const Scene scene = builder.build();
    for (const std::uint32_t bounces : {0u, 3u}) {
        RenderSettings settings = element_settings();
        settings.samples = 128;
        settings.max_bounces = bounces;
        GetParam().choose(settings);
        glm::dvec3 sum(0);
        for (std::uint32_t k = 0; k <= bounces; ++k) sum += glm::pow(a, glm::dvec3(k));
        expect_irradiance(scene, pieces(scene, 0, 3), settings,
                          [=](const glm::dvec3&) { return PI * e * sum; });
    }
}

TEST_F(Irradiance, UnderAPointLightIsItsMeanOverTheElement) {
    SceneBuilder builder;
    builder.square({0, 0, 0}, {0, 1, 0}, 1,
                   builder.material(metal({1, 1, 1}, 0.1f))); // whatever it is made of
    builder.point_light({0.3f, 0.8f, 0.2f}, {2, 3, 4});
    const Scene scene = builder.build();
    const Field field = [](const glm::dvec3& p) {
        const glm::dvec3 to_light = glm::dvec3(0.3, 0.8, 0.2) - p;
        const double distance = glm::length(to_light);
        return glm::dvec3(2, 3, 4) * (to_light.y / distance / (distance * distance));
    };
    // Large pieces tell whether points are uniform over them, small ones where they are.
    for (const int rows : {1, 2, 16})
        expect_irradiance(scene, pieces(scene, 0, rows), element_settings(), field, 1e-3);
}

TEST_F(Irradiance, FollowsAnInstanceThatMirrors) {
    SceneBuilder builder;
    builder.quad({0, 0, 0}, {0, 0, 1}, {3, 0, 1}, {1, 0, 0}, builder.material(lambert({1, 1, 1})));
    builder.point_light({1.5f, 0.8f, 1.2f}, {1, 1, 1});
    Scene scene = builder.build();
    scene.instances[0].to_world = glm::translate(glm::mat4(1), {2, 0, 1}) *
                                  glm::scale(glm::mat4(1), {-1, 1, 1}); // and turns the front upwards still
    scene.instances.push_back(scene.instances[0]); // shared, as meshes that are not baked are
    scene.instances[1].to_world = glm::translate(glm::mat4(1), {0, -3, 0});
    const Field field = [](const glm::dvec3& p) {
        const glm::dvec3 to_light = glm::dvec3(1.5, 0.8, 1.2) - p;
        return glm::dvec3(to_light.y / std::pow(glm::length(to_light), 3));
    };
    RenderSettings settings = element_settings();
    settings.bake_below_triangles = 0;
    expect_irradiance(scene, pieces(scene, 0, 8), settings, field, 1e-3);
}

TEST_F(Irradiance, UnderAConstantEnvironmentIsPiTimesItOnBothSides) {
    SceneBuilder builder;
    builder.square({0, 0, 0}, {0, 1, 0}, 1, builder.material(lambert({0.5f, 0.5f, 0.5f})));
    builder.constant_environment({1, 0.5f, 2});
    const Scene scene = builder.build();
    RenderSettings settings = element_settings();
    settings.max_bounces = 3;
    for (const std::uint32_t side : {0u, shared::ELEMENT_BACK})
        expect_irradiance(scene, pieces(scene, 0, 3, side), settings,
                          [](const glm::dvec3&) { return PI * glm::dvec3(1, 0.5, 2); });
}

TEST_F(Irradiance, OnTheBackDoesNotSeeWhatTheFrontSees) {
    const Scene scene = under_a_square_light();
    for (const char* strategy : {"mis", "light", "bsdf"}) {
        RenderSettings settings = element_settings();
        settings.samples = 16;
        settings.strategy = strategy;
        expect_irradiance(scene, pieces(scene, 0, 3, shared::ELEMENT_BACK), settings,
                          [](const glm::dvec3&) { return glm::dvec3(0); });
    }
}

TEST_F(Irradiance, FallsOnTheShadingNormal) {
    SceneBuilder builder;
    builder.sphere({0, 0, 0}, 1, 4, Normals::smooth, builder.material(lambert({1, 1, 1})));
    builder.directional_light({-0.5f, -0.3f, -1}, {PI, PI, PI});
    const Scene scene = builder.build();
    const glm::dvec3 to_light = glm::normalize(glm::dvec3(0.5, 0.3, 1));
    std::vector<SceneElement> lit;
    for (const SceneElement& e : pieces(scene, 0, 1))
        if (glm::dot(glm::normalize(place_of(scene, e, {0.3, 0.3})), to_light) > 0.1) lit.push_back(e);
    expect_irradiance(
        scene, lit, element_settings(),
        [=](const glm::dvec3& p) { return glm::dvec3(PI * glm::dot(glm::normalize(p), to_light)); },
        1e-3); // 16-bit normals
}

TEST_F(Irradiance, OfAmbientOcclusionBesideAWallIsItsFormFactor) {
    // A wall of height h, endless to both sides, takes (1 - x / sqrt(x^2 + h^2)) / 2 of a floor point's sky.
    SceneBuilder builder;
    const std::uint32_t white = builder.material(lambert({1, 1, 1}));
    builder.quad({0, 0, 500}, {4, 0, 500}, {4, 0, -500}, {0, 0, -500}, white);
    builder.quad({0, 0, 500}, {0, 0, -500}, {0, 2, -500}, {0, 2, 500}, white);
    const Scene scene = builder.build();
    RenderSettings settings = element_settings();
    settings.integrator = "ao";
    settings.ao_distance = 5000;
    std::vector<SceneElement> strips; // around the middle, along the wall
    for (int i = 0; i < 16; ++i) {
        // Of the triangle (0, 0, 500), (4, 0, 500), (4, 0, -500): x = 4 (u + v), z = 500 - 1000 v.
        const float x = static_cast<float>(i) / 32 + 0.5f;
        strips.push_back({0, 0, shared::ELEMENT_QUAD, {x - 0.5f, 0.5f}, {1.0f / 32, 0}, {-0.01f, 0.01f}});
        if (strips.back().origin.x < 0.01f) strips.pop_back();
    }
    expect_irradiance(
        scene, strips, settings,
        [](const glm::dvec3& p) { return glm::dvec3(0.5 + 0.5 * p.x / std::sqrt(p.x * p.x + 4)); }, 1e-4);
}

} // namespace
} // namespace ajar::test
