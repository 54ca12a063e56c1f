// What every sampler of the table promises: each number is uniform, dimensions know nothing of each other,
// and neither do seeds, nor pixels unless it is the sampler's purpose.
#include "render/choices.hpp"
#include "render/render.hpp"
#include "sample_sequence.hpp"

namespace ajar::test {
namespace {

// A few places in a render: all of a sampler's decisions but those of long paths.
constexpr std::uint32_t DIMENSIONS[] = {shared::DIM_PIXEL,
                                        shared::DIM_LENS,
                                        shared::DIM_BOUNCE_FIRST + shared::DIM_BSDF,
                                        shared::DIM_BOUNCE_FIRST + shared::DIM_LIGHT,
                                        shared::DIM_BOUNCE_FIRST + shared::DIM_BSDF_LOBE,
                                        shared::DIM_BOUNCE_FIRST + shared::DIM_PER_BOUNCE};

class Samplers : public SampleSequence, public testing::WithParamInterface<std::size_t> {
  protected:
    // Sequences of 64 samples a pixel.
    static SamplerVariant variant() { return {find_sampler(samplers()[GetParam()].name), 6}; }
    static bool joins_pixels() { return variant().sampler == shared::SAMPLER_BLUE_NOISE; }

    // Columns x, y and z of points k with keys base(k).
    template <class Key> static std::vector<std::vector<float>> columns(std::uint32_t count, const Key& key) {
        std::vector<glm::uvec4> keys;
        keys.reserve(count);
        for (std::uint32_t k = 0; k < count; ++k) keys.push_back(key(k));
        std::vector<std::vector<float>> columns(3);
        for (const glm::vec4& p : points(keys, variant()))
            for (int c = 0; c < 3; ++c) columns[static_cast<std::size_t>(c)].push_back(p[c]);
        return columns;
    }
};
INSTANTIATE_TEST_SUITE_P(Table, Samplers, testing::Range(std::size_t{0}, samplers().size()),
                         [](const auto& row) {
                             std::string name = samplers()[row.param].name;
                             std::erase(name, '-');
                             return name;
                         });

TEST_P(Samplers, StaysBelowOneAndIsNeverNegative) {
    std::mt19937 random(4);
    std::vector<glm::uvec4> keys;
    for (int k = 0; k < 1'000'000; ++k)
        keys.emplace_back(static_cast<std::uint32_t>(random()), static_cast<std::uint32_t>(random()),
                          static_cast<std::uint32_t>(random()) & 63u,
                          static_cast<std::uint32_t>(random()) & 255u);
    for (const glm::vec4& p : points(keys, variant())) {
        ASSERT_GE(std::min({p.x, p.y, p.z}), 0.0f);
        ASSERT_LE(std::max({p.x, p.y, p.z}), LARGEST_UNIFORM);
    }
}

TEST_P(Samplers, AnySampleOfAnyPixelIsUniformOverSeedsInEveryDimension) {
    // That is: unbiased, whatever the integrand. Seeds 0, 1, 2...: a weak hash would show.
    constexpr std::uint32_t SEEDS = 1 << 16;
    const std::pair<std::uint32_t, std::uint32_t> places[] = {
        {0, 0}, {1, 0}, {2, 63}, {12345, 17}, {1u << 26, 5}};
    const double level = sidak_level(SIGNIFICANCE, std::size(places) * std::size(DIMENSIONS) * 4);
    for (const auto& [ordinal, sample] : places) {
        for (const std::uint32_t d : DIMENSIONS) {
            const auto of =
                columns(SEEDS, [&](std::uint32_t seed) { return glm::uvec4(seed, ordinal, sample, d); });
            for (const std::vector<float>& column : of) {
                std::vector<double> observed(256);
                for (const float u : column) ++observed[static_cast<std::size_t>(u * 256)];
                EXPECT_GT(chi_square(observed, std::vector<double>(256, SEEDS / 256.0)).p, level)
                    << ordinal << " " << d;
            }
            EXPECT_GT(independence(of[0], of[1]), level) << ordinal << " " << d;
        }
    }
}

TEST_P(Samplers, DimensionsOfASampleAreIndependentOverSeeds) {
    constexpr std::uint32_t SEEDS = 1 << 16;
    std::vector<std::vector<float>> all;
    for (const std::uint32_t d : DIMENSIONS)
        for (auto& column : columns(SEEDS, [&](std::uint32_t seed) { return glm::uvec4(seed, 77, 3, d); }))
            all.push_back(std::move(column));
    const std::size_t tests = all.size() * (all.size() - 1) / 2;
    for (std::size_t a = 0; a < all.size(); ++a)
        for (std::size_t b = (a / 3 + 1) * 3; b < all.size(); ++b)
            EXPECT_GT(independence(all[a], all[b]), sidak_level(SIGNIFICANCE, tests)) << a << " " << b;
}

TEST_P(Samplers, NeighbouringKeysAreIndependent) {
    // Seeds, dimensions and pixels side by side, where a weak hash would show.
    constexpr std::uint32_t COUNT = 1 << 17;
    const glm::uvec4 steps[] = {{1, 0, 0, 0}, {0, 0, 0, 2}, {0, 0, 0, 8}, {0, 1, 0, 0}, {0, 1u << 18, 0, 0}};
    const std::pair<std::size_t, std::size_t> pairs[] = {{0, 0}, {1, 1}, {0, 1}, {1, 0}, {2, 2}};
    constexpr std::size_t TESTS = 2 * std::size(steps) * std::size(pairs);
    for (const std::uint32_t sample : {0u, 41u}) {
        for (const glm::uvec4& step : steps) {
            if (joins_pixels() && step.y == 1) continue; // neighbours share their strata
            // A picture whose pixels share a sequence is random by its seed alone.
            const bool one_seed = step.y != 0 && !joins_pixels();
            const auto key = [&](std::uint32_t k) {
                return glm::uvec4(one_seed ? 9 : 2 * k, 2 * k, sample, 4);
            };
            const auto a = columns(COUNT, key);
            const auto b = columns(COUNT, [&](std::uint32_t k) { return key(k) + step; });
            for (const auto& [of_a, of_b] : pairs)
                EXPECT_GT(independence(a[of_a], b[of_b]), sidak_level(SIGNIFICANCE, TESTS))
                    << "step " << step.x << " " << step.y << " " << step.w << ", columns " << of_a << " "
                    << of_b;
        }
    }
}

TEST_P(Samplers, DimensionsOfAPixelAreUncorrelatedOverItsSamples) {
    // Padding works only if pairs are shuffled independently: the mean of the product of two centred
    // dimensions over one pixel's 16 samples has mean 0 over pixels. Its variance is that of 16 independent
    // points, or up to that of 8 for Sobol's: samples 2k and 2k + 1 fall into opposite halves of every
    // dimension, so their products agree in part.
    constexpr std::uint32_t PIXELS = 8192;
    constexpr std::uint32_t SAMPLES = 16;
    std::vector<std::vector<float>> all;
    for (const std::uint32_t d : DIMENSIONS) {
        // Pixels of pictures of their own, so that they are independent.
        const auto of = columns(PIXELS * SAMPLES,
                                [&](std::uint32_t k) { return glm::uvec4(k / SAMPLES, 5, k % SAMPLES, d); });
        all.push_back(of[0]);
        all.push_back(of[1]);
    }
    const double level = sidak_level(SIGNIFICANCE, all.size() * (all.size() - 1) / 2);
    for (std::size_t a = 0; a < all.size(); ++a) {
        for (std::size_t b = a + 1; b < all.size(); ++b) {
            Moments moments;
            for (std::size_t pixel = 0; pixel < PIXELS; ++pixel) {
                double sum = 0;
                for (std::size_t i = pixel * SAMPLES; i < (pixel + 1) * SAMPLES; ++i)
                    sum += (double{all[a][i]} - 0.5) * (double{all[b][i]} - 0.5);
                moments.add(sum / SAMPLES);
            }
            EXPECT_GT(mean_p_value(moments, 0), level) << a << " " << b;
            EXPECT_LT(moments.variance(), 1.15 / 144 / (SAMPLES / 2)) << a << " " << b;
        }
    }
}

} // namespace
} // namespace ajar::test
