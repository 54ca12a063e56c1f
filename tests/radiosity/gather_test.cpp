// Pictures of a solution against path traced ones, pixel by pixel: the error of a final gather falls with the
// size of patches.
#include "radiosity/patch_picture.hpp"
#include "radiosity_test.hpp"

#include <cmath>

namespace ajar::test {
namespace {

// A room whose walls meet where patches do, and a box that hangs free: where surfaces touch within patches,
// as under a box that stands on the floor, errors fall with the root of the size alone.
Scene box_in_view() {
    SceneBuilder builder;
    const std::uint32_t white = builder.material(lambert({0.8f, 0.7f, 0.6f}));
    builder.room({0, 0, 0}, {2, 2, 2}, white);
    builder.box({0.6f, 0.7f, 0.5f}, {1.3f, 0.9f, 1.2f}, white);
    builder.square({1, 1.95f, 1}, {0, -1, 0}, 0.3f, builder.material(emitter({10, 10, 10})));
    builder.perspective({1, 1.2f, 1.95f}, {1, 0.8f, 0}, 1.4f);
    return builder.build();
}

RenderSettings picture_settings(std::uint32_t seed) {
    RenderSettings settings;
    settings.width = settings.height = 32;
    settings.samples = 256;
    settings.seed = seed;
    settings.max_bounces = 40;
    return settings;
}

// Residuals of 5 % in 3,072 values leave so much of a bias that is not there.
constexpr double NOISE = 0.01;

class GatherTest : public RadiosityTest {
  protected:
    static std::vector<float> gathered(const Scene& scene, std::uint32_t patches, std::uint32_t seed,
                                       const char* shading) {
        RadiositySettings settings = settings_of(patches, 1024);
        settings.render.seed = seed;
        Renderer renderer(device(), scene, {});
        renderer.show(patch_picture(solve(scene, settings)));
        RenderSettings picture = picture_settings(seed);
        picture.integrator = "radiosity";
        picture.shading = shading;
        return renderer.render(picture).image.find("")->pixels;
    }
    static std::vector<float> traced(const Scene& scene, std::uint32_t seed) {
        return Renderer(device(), scene, {}).render(picture_settings(seed)).image.find("")->pixels;
    }
    // Root mean square of the difference in the mean, relative to the picture's. Residuals of independent
    // pictures, multiplied, are squares of it without their noise.
    static double bias(const std::vector<float> (&found)[2], const std::vector<float> (&right)[2]) {
        double cross = 0, mean = 0;
        for (std::size_t i = 0; i < found[0].size(); ++i) {
            if (i % 4 == 3) continue; // alpha
            cross += (found[0][i] - right[0][i]) * (found[1][i] - right[1][i]);
            mean += right[0][i];
        }
        const double count = 0.75 * static_cast<double>(found[0].size());
        return std::sqrt(std::max(cross / count, 0.0)) / (mean / count);
    }
};

TEST_F(GatherTest, ApproachesPathTracingAsPatchesShrink) {
    const Scene scene = box_in_view();
    const std::vector<float> right[2] = {traced(scene, 11), traced(scene, 12)};
    double last = 0;
    for (const std::uint32_t patches : {100u, 400u, 1600u}) { // half the size each time
        const std::vector<float> found[2] = {gathered(scene, patches, 1, "gather"),
                                             gathered(scene, patches, 2, "gather")};
        const double now = bias(found, right);
        RecordProperty("bias_" + std::to_string(patches), std::to_string(now));
        if (last > 0) {
            EXPECT_LT(now, std::max(0.6 * last, NOISE)) << patches << " patches";
        }
        last = now;
    }
    EXPECT_LT(last, 0.02);
}

TEST_F(GatherTest, IsBetterThanPatchesThemselves) {
    const Scene scene = box_in_view();
    const std::vector<float> right[2] = {traced(scene, 11), traced(scene, 12)};
    const auto bias_of = [&](const char* shading) {
        const std::vector<float> found[2] = {gathered(scene, 400, 1, shading),
                                             gathered(scene, 400, 2, shading)};
        return bias(found, right);
    };
    const double gather = bias_of("gather");
    for (const char* other : {"flat", "smooth"}) {
        EXPECT_LT(gather, 0.5 * bias_of(other)) << other;
        EXPECT_LT(bias_of(other), 0.2) << other;
    }
}

} // namespace
} // namespace ajar::test
