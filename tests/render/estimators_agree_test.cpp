// Different estimators of one integral have one mean: BSDF sampling, light sampling, their combination, the
// naive integrator, and the light samplers, on small scenes of every kind of light and surface.
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

TEST_P(EstimatorsAgree, OnTheMean) {
    const Scene scene = GetParam().build();
    RenderSettings reference_settings = settings(1, 128);
    const Image reference = render(scene, reference_settings);

    RenderSettings other = settings(2, 256);
    other.strategy = "bsdf";
    expect_equal_means(reference, render(scene, other), "mis and bsdf");

    other = settings(3, 256);
    other.integrator = "naive";
    expect_equal_means(reference, render(scene, other), "mis and naive");

    other = settings(4, 128);
    other.light_sampler = "uniform";
    expect_equal_means(reference, render(scene, other), "power and uniform");

    if (!GetParam().light_alone) return;
    other = settings(5, 128);
    other.strategy = "light";
    expect_equal_means(reference, render(scene, other), "mis and light");

    other = settings(6, 256);
    other.integrator = "naive";
    other.naive_sampling = "cosine";
    expect_equal_means(reference, render(scene, other), "mis and naive by the cosine");
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
