// The same bits whatever decides only how fast an image comes: pool, segments, workgroups, slices, tables,
// threads, and whether its samples are rendered in one run or in several.
#include "render_test.hpp"
#include "small_scenes.hpp"

#include <algorithm>
#include <bit>
#include <stdlib.h>

namespace ajar::test {
namespace {

RenderSettings odd_settings() {
    RenderSettings settings;
    settings.width = 37; // fills neither segments nor workgroups evenly
    settings.height = 23;
    settings.samples = 12;
    settings.max_bounces = 4;
    settings.rr_depth = 2;
    settings.seed = 7;
    settings.aovs = true;
    return settings;
}

// A device of its own, under the validation layer like the fixture's.
gpu::DeviceOptions validated() {
    gpu::DeviceOptions options;
    options.validation = true;
    options.on_validation = [](std::string_view message) { ADD_FAILURE() << message; };
    return options;
}

void expect_same_bits(const Image& a, const Image& b) {
    ASSERT_EQ(a.layers.size(), b.layers.size());
    for (std::size_t i = 0; i < a.layers.size(); ++i) {
        const Layer& of_a = a.layers[i];
        const Layer& of_b = b.layers[i];
        ASSERT_EQ(of_a.name, of_b.name);
        ASSERT_EQ(of_a.pixels.size(), of_b.pixels.size());
        std::size_t different = 0;
        for (std::size_t k = 0; k < of_a.pixels.size(); ++k)
            if (std::bit_cast<std::uint32_t>(of_a.pixels[k]) != std::bit_cast<std::uint32_t>(of_b.pixels[k]))
                ++different;
        EXPECT_EQ(different, 0u) << "values of layer '" << of_a.name << "', of " << of_a.pixels.size();
    }
}

struct SampledScene {
    SmallScene scene;
    std::string sampler;
};

void PrintTo(const SampledScene& sampled, std::ostream* out) {
    *out << sampled.scene.name << " by " << sampled.sampler;
}

class Determinism : public RenderTest, public testing::WithParamInterface<SampledScene> {
  protected:
    static Scene build() { return GetParam().scene.build(); }
    static RenderSettings sampled_settings() {
        RenderSettings settings = odd_settings();
        settings.sampler = GetParam().sampler;
        return settings;
    }
    static Image render_on(const gpu::DeviceOptions& options, const Scene& scene) {
        const gpu::Device other(options);
        return render_checked(other, scene, sampled_settings()).image;
    }
};
// Between them: every kind of surface, texture and light but a mirror's; Cards toss coins along rays. One of
// them with every sampler.
std::vector<SampledScene> sampled_scenes() {
    std::vector<SampledScene> all;
    for (const std::size_t i : {1u, 3u, 4u, 6u}) all.push_back({small_scenes()[i], RenderSettings().sampler});
    for (const Choice& row : samplers())
        if (row.name != RenderSettings().sampler) all.push_back({small_scenes()[1], row.name});
    return all;
}

INSTANTIATE_TEST_SUITE_P(Scenes, Determinism, testing::ValuesIn(sampled_scenes()), [](const auto& row) {
    std::string name = row.param.scene.name;
    if (row.param.sampler != RenderSettings().sampler) name += "_" + row.param.sampler;
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
});

TEST_P(Determinism, WhateverThePoolTheSegmentsAndTheSlices) {
    const Scene scene = build();
    const Image reference = render(scene, sampled_settings());
    struct Choice {
        std::uint32_t segment, pool;
    };
    // A pool of one segment, one that the picture does not fill evenly, and one that holds everything.
    for (const auto& [segment, pool] :
         {Choice{64, 1}, Choice{64, 3000}, Choice{256, 1u << 16}, Choice{1024, 3000}}) {
        RenderSettings settings = sampled_settings();
        settings.segment_paths = segment;
        settings.pool_paths = pool;
        SCOPED_TRACE(testing::Message() << "segments of " << segment << ", pool of " << pool);
        expect_same_bits(reference, render(scene, settings));
    }
    RenderSettings settings = sampled_settings();
    settings.slice_seconds = 1e-6; // as short as slices get
    settings.pool_paths = 3000;
    expect_same_bits(reference, render(scene, settings));
    settings.slice_seconds = 100;
    expect_same_bits(reference, render(scene, settings));
}

TEST_P(Determinism, WhateverTheTablesAndTheWorkgroups) {
    const Scene scene = build();
    const Image reference = render(scene, sampled_settings());
    gpu::DeviceOptions options = validated();
    options.force_pointers = true;
    expect_same_bits(reference, render_on(options, scene));
    options.force_pointers = false;
    for (const std::uint32_t size : {8u, 32u, 64u}) {
        options.workgroup_size = size;
        SCOPED_TRACE(testing::Message() << "workgroups of " << size);
        expect_same_bits(reference, render_on(options, scene));
    }
}

// Light samplers that look at the point, and one that first learns about it in a pass of its own: whatever
// cuts that pass into pieces.
class DeterminismOfLightSamplers : public RenderTest, public testing::WithParamInterface<const char*> {};
INSTANTIATE_TEST_SUITE_P(Looking, DeterminismOfLightSamplers, testing::Values("tree", "visibility"),
                         [](const auto& row) { return std::string(row.param); });

TEST_P(DeterminismOfLightSamplers, WhateverThePoolTheWorkgroupsAndTheTables) {
    const Scene scene = small_scenes()[7].build(); // every kind of light
    RenderSettings settings = odd_settings();
    settings.light_sampler = GetParam();
    Renderer renderer(device(), scene, {});
    const Image reference = renderer.render(settings).image;
    expect_same_bits(reference, renderer.render(settings).image); // what was learned is kept
    settings.segment_paths = 64;
    settings.pool_paths = 3000;
    expect_same_bits(reference, renderer.render(settings).image);
    gpu::DeviceOptions options = validated();
    options.force_pointers = true;
    options.workgroup_size = 32;
    const gpu::Device other(options);
    expect_same_bits(reference, render_checked(other, scene, settings).image);
}

TEST_F(RenderTest, LearningDoesNotDependOnWhichSamplesFollow) {
    const Scene scene = small_scenes()[5].build();
    RenderSettings settings = odd_settings();
    settings.light_sampler = "visibility";
    settings.samples = 1;
    settings.first_sample = 5;
    const Image alone = render(scene, settings);
    Renderer renderer(device(), scene, {});
    settings.first_sample = 0;
    renderer.render(settings);
    settings.first_sample = 5;
    expect_same_bits(alone, renderer.render(settings).image);
}

TEST_P(Determinism, OneRendererRepeatsItself) {
    const Scene scene = build();
    Renderer renderer(device(), scene, {});
    const Image first = renderer.render(sampled_settings()).image;
    RenderSettings other = sampled_settings();
    other.width = 64;
    other.integrator = "ao";
    renderer.render(other);
    expect_same_bits(first, renderer.render(sampled_settings()).image);
}

TEST_P(Determinism, PartsOfTheSamplesSumToTheWhole) {
    const Scene scene = build();
    const Image whole = render(scene, sampled_settings());
    RenderSettings part = sampled_settings();
    part.samples = 4;
    part.sequence_samples = 12;
    std::vector<Image> parts;
    for (part.first_sample = 0; part.first_sample < 12; part.first_sample += 4)
        parts.push_back(render(scene, part));
    for (std::uint32_t y = 0; y < whole.height; ++y)
        for (std::uint32_t x = 0; x < whole.width; ++x)
            for (int c = 0; c < 3; ++c) {
                const double right = pixel(whole, "", x, y)[c];
                double mean = 0;
                for (const Image& image : parts) mean += pixel(image, "", x, y)[c] / 3;
                // Film sums are exact; each part's mean was rounded to a float once.
                EXPECT_NEAR(mean, right, 0x1p-23 * right) << x << ", " << y;
            }
}

TEST_F(RenderTest, ThreadsOfTheCpuDriverDoNotChangeTheImage) {
    if (!device().limits().is_cpu) GTEST_SKIP() << "threads are a CPU driver's";
    const Scene scene = small_scenes()[1].build();
    std::vector<Image> images;
    for (const char* threads : {"1", "2", "3"}) {
        ::setenv("LP_NUM_THREADS", threads, 1);
        const gpu::Device other(validated());
        images.push_back(render_checked(other, scene, odd_settings()).image);
    }
    ::unsetenv("LP_NUM_THREADS");
    expect_same_bits(images[0], images[1]);
    expect_same_bits(images[0], images[2]);
}

TEST_F(RenderTest, AnotherSeedIsAnotherImage) {
    const Scene scene = small_scenes()[0].build();
    RenderSettings settings = odd_settings();
    const Image a = render(scene, settings);
    settings.seed = 8;
    const Image b = render(scene, settings);
    EXPECT_NE(beauty(a, "a").pixels, beauty(b, "b").pixels);
}

} // namespace
} // namespace ajar::test
