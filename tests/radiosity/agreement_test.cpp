// Radiosity against path tracing: two algorithms, one answer.
#include "radiosity_test.hpp"
#include "render/luminance.hpp"

#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

namespace ajar::test {
namespace {

// Irradiance of the solution's active sides by paths from them.
std::vector<glm::vec3> path_traced(const gpu::Device& device, const Scene& scene,
                                   const RadiositySolution& solution, std::uint32_t samples,
                                   std::uint32_t seed) {
    std::vector<SceneElement> elements;
    std::vector<std::size_t> sides;
    for (std::size_t side = 0; side < solution.active.size(); ++side) {
        if (solution.active[side] == 0) continue;
        const Patch& patch = solution.mesh.patches[side / 2];
        const PatchSource& source = solution.mesh.sources[patch.source];
        glm::vec2 at[3] = {patch.corners[0], patch.corners[1], patch.corners[2]};
        if (mirrors(scene.instances[source.instance].to_world)) // patches know the triangle as it is placed
            for (glm::vec2& corner : at) corner = glm::vec2(corner.y, corner.x);
        elements.push_back({source.instance, source.triangle,
                            side % 2 == shared::PATCH_BACK ? shared::ELEMENT_BACK : 0u, at[0], at[1] - at[0],
                            at[2] - at[0]});
        sides.push_back(side);
    }
    RenderSettings settings = solution.stats.settings.render;
    settings.samples = samples;
    settings.max_bounces = 64;
    settings.seed = seed;
    const ElementRadiance light = Renderer(device, scene, {}).irradiance(elements, settings);
    std::vector<glm::vec3> irradiance(solution.active.size(), glm::vec3(0));
    for (std::size_t i = 0; i < sides.size(); ++i) irradiance[sides[i]] = light.irradiance[i];
    return irradiance;
}

// By area, of what is reflected.
struct Difference {
    double mean = 0;   // |found - right| / mean of right
    double bright = 0; // mean of found / mean of right - 1
};
Difference difference(const RadiositySolution& solution, const std::vector<glm::vec3>& right) {
    double absolute = 0, found_sum = 0, right_sum = 0;
    for (std::size_t side = 0; side < right.size(); ++side) {
        const double weight = solution.active[side] * solution.mesh.patches[side / 2].area;
        const double found = luminance(glm::dvec3(solution.reflectance[side] * solution.irradiance[side]));
        const double expected = luminance(glm::dvec3(solution.reflectance[side] * right[side]));
        absolute += weight * std::abs(found - expected);
        found_sum += weight * found;
        right_sum += weight * expected;
    }
    return {absolute / right_sum, found_sum / right_sum - 1};
}

class RadiosityAgrees : public RadiosityTest {
  protected:
    static void expect_agreement(const Scene& scene, const RadiositySettings& settings, double mean_error) {
        const RadiositySolution solution = solve_radiosity(device(), scene, settings);
        EXPECT_TRUE(solution.stats.converged);
        const Difference d = difference(solution, path_traced(device(), scene, solution, 1024, 77));
        EXPECT_LT(d.mean, mean_error) << settings.direct;
        EXPECT_LT(std::abs(d.bright), 0.3 * mean_error) << settings.direct;
    }
};

TEST_F(RadiosityAgrees, InTheCornellBox) {
    for (const Choice& direct : radiosity_directs()) {
        RadiositySettings settings = settings_of(1500, 1024);
        settings.direct = direct.name;
        // Through the matrix, what comes from the light is a hundredth of a row's rays: noise.
        expect_agreement(small_cornell_box(), settings, settings.direct == "shadow-rays" ? 0.03 : 0.09);
    }
}

TEST_F(RadiosityAgrees, UnderLightsThatAreNoPatches) {
    SceneBuilder builder;
    const std::uint32_t grey = builder.material(lambert({0.6f, 0.5f, 0.4f}));
    builder.square({0, 0, 0}, {0, 1, 0}, 2, grey);
    builder.square({-2, 2, 0}, {1, 0, 0}, 2, grey);
    builder.box({-0.5f, 0.3f, -0.5f}, {0.5f, 0.9f, 0.5f}, grey);
    builder.point_light({1, 1.5f, 1}, {3, 2, 1});
    builder.spot_light({1.5f, 2, -1}, {-0.6f, -0.8f, 0}, {4, 4, 6}, 0.2f, 0.7f);
    builder.directional_light({0.3f, -1, 0.2f}, {1, 1, 1});
    builder.constant_environment({0.3f, 0.4f, 0.6f});
    builder.sphere_light({1.2f, 0.5f, 1.2f}, 0.2f, builder.material(emitter({4, 4, 4})));
    builder.square({0.5f, 2.5f, 0.5f}, {0, -1, 0}, 0.3f, builder.material(emitter({3, 4, 5})));
    for (const Choice& direct : radiosity_directs()) {
        RadiositySettings settings = settings_of(1500, 512);
        settings.direct = direct.name;
        settings.shadow_samples = 512;                     // each goes to one of the lights
        expect_agreement(builder.build(), settings, 0.05); // hard shadows, and patches of 10 cm
    }
}

TEST_F(RadiosityAgrees, OnTexturesTwoSidesAndMirroredInstances) {
    SceneBuilder builder;
    Material checker = lambert({1, 1, 1});
    checker.base_color_texture.texture =
        builder.texture(4, 1, {250, 40, 40, 255, 40, 250, 40, 255, 40, 40, 250, 255, 220, 220, 220, 255},
                        TextureFilter::nearest);
    builder.quad({0, 0, 0}, {0, 0, 2}, {2, 0, 2}, {2, 0, 0}, builder.material(checker));
    Material leaf = lambert({0.7f, 0.7f, 0.2f});
    leaf.double_sided = true;
    builder.quad({0.2f, 0.7f, 0.3f}, {0.2f, 0.9f, 1.2f}, {1.1f, 1.2f, 1.3f}, {1.2f, 0.8f, 0.2f},
                 builder.material(leaf));
    Material glow = emitter({3, 3, 3});
    glow.double_sided = true;
    builder.square({0.4f, 1.6f, 1.4f}, glm::normalize(glm::vec3(0.3f, -1, 0)), 0.3f, builder.material(glow));
    Scene scene = builder.build();
    const std::size_t count = scene.instances.size();
    for (std::size_t i = 0; i < count; ++i) { // all of it again, beside itself in a mirror
        scene.instances.push_back(scene.instances[i]);
        scene.instances.back().to_world =
            glm::scale(glm::mat4(1), {-1, 1, 1}) * scene.instances.back().to_world;
    }
    RadiositySettings settings = settings_of(3000, 512);
    settings.shadow_samples = 128;
    expect_agreement(scene, settings, 0.03);
}

TEST_F(RadiosityAgrees, ByAnErrorThatFallsWithTheSizeOfPatches) {
    // Without noise: residuals of independent solutions and references, multiplied, are squares of the bias
    // in the mean. A room whose walls meet where patches do, and a board that hangs free.
    SceneBuilder builder;
    const std::uint32_t white = builder.material(lambert({0.8f, 0.7f, 0.6f}));
    builder.room({0, 0, 0}, {2, 2, 2}, white);
    builder.box({0.6f, 0.7f, 0.5f}, {1.3f, 0.9f, 1.2f}, white);
    builder.square({1, 1.95f, 1}, {0, -1, 0}, 0.3f, builder.material(emitter({10, 10, 10})));
    const Scene scene = builder.build();
    std::vector<double> biases;
    for (const std::uint32_t patches : {100u, 400u, 1600u}) {
        RadiositySettings settings = settings_of(patches, 1024);
        settings.shadow_samples = 256;
        const RadiositySolution first = solve(scene, settings);
        settings.render.seed = 1;
        const RadiositySolution second = solve(scene, settings);
        const std::vector<glm::vec3> right[2] = {path_traced(device(), scene, first, 512, 2),
                                                 path_traced(device(), scene, first, 512, 3)};
        double cross = 0, area = 0, mean = 0;
        for (std::size_t side = 0; side < first.active.size(); ++side) {
            const double weight = first.active[side] * first.mesh.patches[side / 2].area;
            const auto residual = [&](const RadiositySolution& found,
                                      const std::vector<glm::vec3>& reference) {
                return luminance(
                    glm::dvec3(found.reflectance[side] * (found.irradiance[side] - reference[side])));
            };
            cross += weight * residual(first, right[0]) * residual(second, right[1]);
            mean += weight * luminance(glm::dvec3(first.reflectance[side] * right[0][side]));
            area += weight;
        }
        biases.push_back(std::sqrt(std::max(cross / area, 0.0)) * area / mean);
        RecordProperty("bias_" + std::to_string(patches), std::to_string(biases.back()));
    }
    EXPECT_GT(biases[0], 1e-3) << "there was nothing to converge from";
    // Half the size each time.
    EXPECT_LT(biases[1], 0.55 * biases[0]);
    EXPECT_LT(biases[2], 0.55 * biases[1]);
}

TEST_F(RadiosityAgrees, BetterWhereShadowsAreRefined) {
    const Scene scene = small_cornell_box();
    RadiositySettings settings = settings_of(300, 512);
    settings.refine = 2;
    const RadiositySolution refined = solve(scene, settings);
    EXPECT_GT(refined.mesh.patches.size(), 600u);
    EXPECT_EQ(refined.history.back().mesh, 2u);
    // Patches at shadows' edges are smaller than those elsewhere.
    float smallest = INFINITY;
    float largest = 0;
    for (const Patch& patch : refined.mesh.patches) {
        smallest = std::min(smallest, patch.area);
        largest = std::max(largest, patch.area);
    }
    EXPECT_GT(largest, 3.5f * smallest);
    settings.refine = 0;
    const RadiositySolution coarse = solve(scene, settings);
    EXPECT_LT(difference(refined, path_traced(device(), scene, refined, 256, 5)).mean,
              difference(coarse, path_traced(device(), scene, coarse, 256, 5)).mean);
}

TEST_F(RadiosityAgrees, InEnergy) {
    // What is brought to patches is absorbed or leaves, up to the noise of form factors.
    for (const Choice& direct : radiosity_directs()) {
        RadiositySettings settings = settings_of(1000, 1024);
        settings.direct = direct.name;
        const RadiositySolution open = solve(small_cornell_box(), settings);
        EXPECT_GT(open.stats.power_escaped, 0.05 * open.stats.power_in);
        EXPECT_NEAR(open.stats.power_absorbed + open.stats.power_escaped, open.stats.power_in,
                    0.01 * open.stats.power_in);
        const RadiositySolution closed = solve(furnace_room({0.3f, 0.5f, 0.8f}, {1, 1, 1}), settings);
        EXPECT_EQ(closed.stats.power_escaped, 0);
        EXPECT_NEAR(closed.stats.power_absorbed, closed.stats.power_in, 0.005 * closed.stats.power_in);
    }
}

} // namespace
} // namespace ajar::test
