// Whatever numbers paths are made of, images have one mean.
#include "render_test.hpp"
#include "small_scenes.hpp"

namespace ajar::test {
namespace {

class SamplersAgree : public RenderTest, public testing::WithParamInterface<SmallScene> {};
// Two lobes and an emitter, a sky by inversion, coins tossed along rays.
INSTANTIATE_TEST_SUITE_P(Scenes, SamplersAgree,
                         testing::Values(small_scenes()[1], small_scenes()[3], small_scenes()[6]),
                         [](const auto& row) { return std::string(row.param.name); });

TEST_P(SamplersAgree, OnTheMean) {
    const Scene scene = GetParam().build();
    RenderSettings settings;
    settings.width = settings.height = 64;
    settings.samples = 128;
    settings.max_bounces = 3;
    settings.rr_depth = 2;
    settings.seed = 1; // one for each, so that they share no random numbers
    const Image reference = render(scene, settings);
    for (const Choice& row : samplers()) {
        if (row.name == RenderSettings().sampler) continue;
        ++settings.seed;
        settings.sampler = row.name;
        expect_equal_means(reference, render(scene, settings), row.name);
    }
}

} // namespace
} // namespace ajar::test
