// What holds of a solution besides its value: equal bits, interruption, notices, refusals.
#include "base/error.hpp"
#include "radiosity_test.hpp"

#include <bit>
#include <cstring>

namespace ajar::test {
namespace {

class RadiosityContract : public RadiosityTest {
  protected:
    static bool same_bits(const std::vector<glm::vec3>& a, const std::vector<glm::vec3>& b) {
        return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(glm::vec3)) == 0;
    }
    static void expect_same_bits(const RadiositySolution& a, const RadiositySolution& b) {
        EXPECT_TRUE(same_bits(a.radiance, b.radiance));
        EXPECT_TRUE(same_bits(a.irradiance, b.irradiance));
        EXPECT_TRUE(same_bits(a.emission, b.emission));
        EXPECT_TRUE(same_bits(a.reflectance, b.reflectance));
        EXPECT_EQ(a.active, b.active);
        ASSERT_EQ(a.history.size(), b.history.size());
        for (std::size_t i = 0; i < a.history.size(); ++i)
            EXPECT_EQ(a.history[i].residual, b.history[i].residual);
    }
    // All kinds of surfaces and lights.
    static Scene varied_scene() {
        SceneBuilder builder;
        Material checker = plastic({1, 1, 1}, 0.4f);
        checker.base_color_texture.texture = builder.texture(
            2, 2, {250, 0, 0, 255, 0, 250, 0, 255, 0, 0, 250, 255, 90, 90, 90, 255}, TextureFilter::linear);
        builder.square({0, 0, 0}, {0, 1, 0}, 2, builder.material(checker));
        builder.box({-0.5f, 0.1f, -0.5f}, {0.5f, 0.6f, 0.5f},
                    builder.material(metal({0.9f, 0.6f, 0.3f}, 0.3f)));
        Material leaf = lambert({0.2f, 0.6f, 0.1f});
        leaf.double_sided = true;
        builder.square({1, 0.8f, 0}, glm::normalize(glm::vec3(1, 1, 0)), 0.3f, builder.material(leaf));
        builder.square({-1, 1.5f, 0}, {0, -1, 0}, 0.3f, builder.material(emitter({5, 5, 4})));
        builder.point_light({0.5f, 1, 1}, {1, 1, 1});
        builder.constant_environment({0.2f, 0.25f, 0.4f});
        return builder.build();
    }
};

TEST_F(RadiosityContract, MemoryDoesNotChangeABit) {
    RadiositySettings settings = settings_of(200, 64);
    for (const Choice& row : radiosity_solvers()) {
        settings.solver = row.name;
        settings.memory_bytes = std::uint64_t{1} << 30;
        const RadiositySolution stored = solve(small_cornell_box(), settings);
        EXPECT_EQ(stored.stats.rows_stored, stored.stats.sides);
        for (const std::uint64_t bytes : {std::uint64_t{0}, std::uint64_t{100 * 64 * 4}}) {
            settings.memory_bytes = bytes;
            const RadiositySolution traced = solve(small_cornell_box(), settings);
            EXPECT_EQ(traced.stats.rows_stored, bytes / (64 * 4));
            EXPECT_LE(traced.stats.row_bytes, bytes);
            EXPECT_GT(traced.stats.form_factor_rays, stored.stats.form_factor_rays);
            expect_same_bits(stored, traced);
        }
    }
}

TEST_F(RadiosityContract, NorDoThePoolTheSlicesTheTablesAndTheWorkgroups) {
    const Scene scene = varied_scene();
    RadiositySettings settings = settings_of(150, 128);
    settings.shadow_samples = 16;
    settings.refine = 1;
    const RadiositySolution reference = solve_radiosity(device(), scene, settings);
    // A pool of one segment, in which a row has no place, and one that rows do not fill evenly.
    for (const auto& [segment, pool] : {std::pair{64u, 1u}, {64u, 3000u}, {1024u, 3000u}}) {
        settings.render.segment_paths = segment;
        settings.render.pool_paths = pool;
        expect_same_bits(reference, solve_radiosity(device(), scene, settings));
    }
    settings.render.slice_seconds = 1e-6;
    expect_same_bits(reference, solve_radiosity(device(), scene, settings));
    for (const std::uint32_t workgroup : {8u, 64u}) {
        gpu::DeviceOptions options;
        options.workgroup_size = workgroup;
        options.force_pointers = true;
        const gpu::Device other(options);
        expect_same_bits(reference, solve_radiosity(other, scene, settings));
    }
}

TEST_F(RadiosityContract, AnotherSeedIsAnotherNoise) {
    RadiositySettings settings = settings_of(100, 64);
    const RadiositySolution a = solve(small_cornell_box(), settings);
    settings.render.seed = 1;
    EXPECT_FALSE(same_bits(a.radiance, solve(small_cornell_box(), settings).radiance));
}

TEST_F(RadiosityContract, AStoppedSolutionIsWhatIsKnownSoFar) {
    const Scene scene = small_cornell_box();
    for (const Choice& row : radiosity_solvers()) {
        RadiositySettings settings = settings_of(300, 64);
        settings.solver = row.name;
        const RadiositySolution whole = solve(scene, settings);
        for (const std::string stage : {"materials", "form factors", "direct light", "solve"}) {
            int asked = 0;
            const int stop_at = stage == "solve" ? 4 : 1;
            const RadiositySolution part = solve_radiosity(device(), scene, settings, [&](const Progress& p) {
                EXPECT_LE(p.done, p.total);
                return p.stage != stage || ++asked < stop_at;
            });
            EXPECT_TRUE(part.stats.interrupted) << stage;
            EXPECT_FALSE(part.stats.converged) << stage;
            ASSERT_EQ(part.radiance.size(), 2 * part.mesh.patches.size());
            ASSERT_EQ(part.active.size(), part.radiance.size());
            // Light that was found is there, none that is not; but shooting estimates what is missing.
            std::size_t too_bright = 0;
            for (std::size_t side = 0; side < part.radiance.size(); ++side) {
                EXPECT_TRUE(glm::all(glm::greaterThanEqual(part.radiance[side], part.emission[side])));
                too_bright +=
                    glm::any(glm::greaterThan(part.radiance[side], 1.0001f * whole.radiance[side] + 1e-5f));
            }
            if (stage == "solve" && settings.solver != "shooting") {
                EXPECT_EQ(too_bright, 0u) << settings.solver;
            }
        }
    }
}

TEST_F(RadiosityContract, TheAmbientTermStandsForWhatIsUnshot) {
    // Stopped after a step or two, its total is nearer to the truth than without.
    const Scene scene = small_cornell_box();
    RadiositySettings settings = settings_of(300, 64);
    settings.solver = "shooting";
    settings.direct = "form-factors";
    const RadiositySolution whole = solve(scene, settings);
    std::uint64_t done = 0;
    const RadiositySolution part = solve_radiosity(
        device(), scene, settings, [&](const Progress& p) { return p.stage != "solve" || ++done < 3; });
    const auto power = [](const RadiositySolution& s) {
        double sum = 0;
        for (std::size_t side = 0; side < s.radiance.size(); ++side)
            sum += s.active[side] * s.mesh.patches[side / 2].area * 3.14159265 *
                   glm::dot(s.radiance[side], glm::vec3(0.2126f, 0.7152f, 0.0722f));
        return sum;
    };
    const double shot = part.history.back().power;
    EXPECT_LT(shot, 0.95 * power(whole));
    EXPECT_LT(std::abs(power(part) - power(whole)), 0.7 * (power(whole) - shot));
}

TEST_F(RadiosityContract, NamesMaterialsThatAreTakenForDiffuse) {
    Scene scene = varied_scene();
    for (std::size_t i = 0; i < scene.materials.size(); ++i)
        scene.materials[i].name = "number " + std::to_string(i);
    std::vector<std::string> warnings;
    solve_radiosity(device(), scene, settings_of(50, 16), {},
                    [&](std::string_view line) { warnings.emplace_back(line); });
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_NE(warnings[0].find("'number 0', 'number 1'"), std::string::npos) << warnings[0];
    EXPECT_EQ(warnings[0].find("number 2"), std::string::npos) << warnings[0];
}

TEST_F(RadiosityContract, RefusesWhatMakesNoSense) {
    const Scene scene = small_cornell_box();
    const auto refused = [&](auto&& change) {
        RadiositySettings settings = settings_of(50, 16);
        change(settings);
        EXPECT_THROW(solve_radiosity(device(), scene, settings), Error);
    };
    refused([](RadiositySettings& s) { s.rays = 100; });
    refused([](RadiositySettings& s) { s.rays = 2; });
    refused([](RadiositySettings& s) { s.rays = 1u << 17; });
    refused([](RadiositySettings& s) { s.shadow_samples = 0; });
    refused([](RadiositySettings& s) { s.tolerance = 0; });
    refused([](RadiositySettings& s) { s.tolerance = NAN; });
    refused([](RadiositySettings& s) { s.max_iterations = 0; });
    refused([](RadiositySettings& s) { s.refine = 17; });
    refused([](RadiositySettings& s) { s.patches = {0, 0}; });
    refused([](RadiositySettings& s) { s.solver = "conjugate-gradients"; });
    refused([](RadiositySettings& s) { s.direct = "none"; });
    refused([](RadiositySettings& s) { s.render.light_sampler = "none"; });
    EXPECT_THROW(solve_radiosity(device(), SceneBuilder().build(), settings_of(50, 16)), Error);
}

} // namespace
} // namespace ajar::test
