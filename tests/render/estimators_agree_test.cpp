// Different estimators of one integral have one mean: every combination of strategy, heuristic, light
// sampler, number of light rays and sampling of environments that the tables offer, and the naive
// integrator, on small scenes of every kind of light and surface.
#include "base/error.hpp"
#include "render_test.hpp"
#include "small_scenes.hpp"

namespace ajar::test {
namespace {

class EstimatorsAgree : public RenderTest, public testing::WithParamInterface<SmallScene> {
  protected:
    static RenderSettings settings(std::uint32_t seed, std::uint32_t samples) {
        RenderSettings settings;
        settings.width = settings.height = 64;
        settings.samples = samples;
        settings.seed = seed; // differs per estimator, so that they share no random numbers
        settings.max_bounces = 3;
        settings.rr_depth = 2; // roulette takes part
        return settings;
    }
};
INSTANTIATE_TEST_SUITE_P(Scenes, EstimatorsAgree, testing::ValuesIn(small_scenes()),
                         [](const auto& row) { return std::string(row.param.name); });

// Every combination that the tables offer, but for those in which a choice is not looked at. `map`: there is
// an environment map.
std::vector<RenderSettings> combinations(const RenderSettings& base, bool light_alone, bool map) {
    std::vector<RenderSettings> all;
    const auto add = [&](RenderSettings settings) {
        settings.seed = base.seed + static_cast<std::uint32_t>(all.size());
        all.push_back(std::move(settings));
    };
    for (const Choice& strategy : strategies()) {
        RenderSettings settings = base;
        settings.strategy = strategy.name;
        const bool bsdf = settings.strategy == "bsdf";
        if (settings.strategy == "light" && !light_alone) continue;
        if (bsdf) settings.samples *= 2;
        for (const Choice& rays : light_ray_choices())
            for (const Choice& sampler : light_samplers()) {
                settings.light_rays = rays.name;
                settings.light_sampler = sampler.name;
                const bool first_sampler = &sampler == light_samplers().data();
                const bool first_rays = &rays == light_ray_choices().data();
                if (bsdf && !(first_sampler && first_rays)) continue; // no light is picked
                if (settings.light_rays == "all" && !first_sampler) continue;
                add(settings);
            }
    }
    for (const Choice& heuristic : heuristics()) {
        RenderSettings settings = base;
        settings.heuristic = heuristic.name;
        if (heuristic.name != base.heuristic) add(settings);
    }
    for (const Choice& sampling : environment_samplings())
        for (const Choice& sampler : light_samplers()) {
            RenderSettings settings = base;
            settings.environment_sampling = sampling.name;
            settings.light_sampler = sampler.name;
            if (map && sampling.name != base.environment_sampling) add(settings);
        }
    return all;
}

std::string name_of(const RenderSettings& s) {
    return s.strategy + ", " + s.heuristic + ", light sampler " + s.light_sampler + ", rays " + s.light_rays +
           ", environment " + s.environment_sampling;
}

TEST_P(EstimatorsAgree, OnTheMean) {
    const Scene scene = GetParam().build();
    RenderSettings naive = settings(1, 256);
    naive.integrator = "naive";
    const Image reference = render(scene, naive);
    // Naive sees no light that has no extent: the first other combination is then the measure.
    const bool blind = !scene.lights.empty();
    std::optional<Image> measure;
    if (!blind) measure = reference;
    const bool map = scene.environment && !scene.environment->radiance.empty();
    for (const RenderSettings& combination : combinations(settings(10, 128), GetParam().light_alone, map)) {
        if (blind && combination.strategy == "bsdf") continue;
        const Image image = render(scene, combination);
        if (measure) expect_equal_means(*measure, image, name_of(combination));
        if (!measure) measure = image;
    }
    if (blind || !GetParam().light_alone) return;
    naive = settings(6, 256);
    naive.integrator = "naive";
    naive.naive_sampling = "cosine";
    expect_equal_means(reference, render(scene, naive), "naive by the cosine");
}

// direct stops where path goes on: the same picture as path without indirect bounces, whatever it is asked.
TEST_P(EstimatorsAgree, OnDirectLight) {
    const Scene scene = GetParam().build();
    RenderSettings path = settings(1, 32);
    path.max_bounces = 0;
    RenderSettings direct = path;
    direct.max_bounces = 5;
    direct.integrator = "direct";
    EXPECT_EQ(beauty(render(scene, path), "path").pixels, beauty(render(scene, direct), "direct").pixels);
}

TEST_F(RenderTest, RouletteAndItsAbsenceHaveEqualMeans) {
    const Scene scene = small_scenes()[0].build();
    RenderSettings settings;
    settings.width = settings.height = 64;
    settings.samples = 256;
    settings.max_bounces = 6;
    settings.seed = 1;
    settings.rr_depth = 0;
    const Image with = render(scene, settings);
    settings.seed = 2;
    settings.rr_depth = 100;
    expect_equal_means(with, render(scene, settings), "with and without roulette");
}

TEST_F(RenderTest, NaiveSamplingByTheCosineFindsNoMirror) {
    SceneBuilder builder;
    builder.square({0, 0, 0}, {0, 1, 0}, 50, builder.material(metal({1, 1, 1}, 0)));
    builder.constant_environment({1, 1, 1});
    builder.perspective({0, 1, 0}, {0, 0, 0}, 0.5f);
    const Scene scene = builder.build();
    RenderSettings settings = small_settings();
    settings.integrator = "naive";
    const auto middle = [&] { return pixel(render(scene, settings), "", 16, 16); };
    EXPECT_NEAR(middle().x, 1, 1e-4) << "by the BSDF, which a delta lobe is part of";
    settings.naive_sampling = "cosine";
    EXPECT_EQ(middle(), glm::dvec3(0));
    settings.naive_sampling = "sine";
    EXPECT_THROW(render(scene, settings), Error);
}

TEST_F(RenderTest, InstancedAndBakedScenesHaveEqualMeans) {
    const Scene scene = small_scenes()[1].build();
    RenderSettings settings;
    settings.width = settings.height = 64;
    settings.samples = 128;
    settings.max_bounces = 3;
    settings.seed = 1;
    const Image baked = render(scene, settings);
    settings.seed = 2;
    settings.bake_below_triangles = 0;
    expect_equal_means(baked, render(scene, settings), "baked and instanced");
}

} // namespace
} // namespace ajar::test
