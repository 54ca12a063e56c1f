// The sample sequence: Sobol's matrix, Owen's scrambling, the net property of every pair, and that pairs and
// pixels know nothing of each other.
#include "core_functions.hpp"
#include "shaders/shared/dimensions.glsl.h"
#include "support/statistics.hpp"

#include <set>

namespace ajar::test {
namespace {

class SampleSequence : public CoreFunctions {
  protected:
    static std::vector<glm::vec4> points(const std::vector<glm::uvec4>& keys) {
        std::vector<glm::vec4> all;
        all.reserve(keys.size());
        for (const glm::uvec4& word : run(shared::CORE_SAMPLER, keys))
            all.push_back(std::bit_cast<glm::vec4>(word));
        return all;
    }
};

std::uint32_t reversed(std::uint32_t x) {
    std::uint32_t y = 0;
    for (int bit = 0; bit < 32; ++bit) y |= (x >> bit & 1u) << (31 - bit);
    return y;
}

// Sobol 1967: the sum of the index's direction numbers; those of the second dimension (primitive polynomial x
// + 1, m1 = 1) follow v[k + 1] = v[k] ^ v[k] >> 1.
std::uint32_t sobol1(std::uint32_t index) {
    std::uint32_t sum = 0;
    std::uint32_t direction = 0x80000000u;
    for (int bit = 0; bit < 32; ++bit, direction ^= direction >> 1)
        if (index >> bit & 1u) sum ^= direction;
    return sum;
}

TEST_F(SampleSequence, UnscrambledIsTheSecondSobolDimension) {
    std::mt19937 random(1);
    std::vector<glm::uvec4> items;
    for (std::uint32_t i = 0; i < 4096; ++i) items.emplace_back(i, 0, 0, 0);
    for (int bit = 0; bit < 32; ++bit) items.emplace_back(1u << bit, 0, 0, 0);
    for (int k = 0; k < 4096; ++k) items.emplace_back(static_cast<std::uint32_t>(random()), 0, 0, 0);
    const auto results = run(shared::CORE_SOBOL, items);
    for (std::size_t k = 0; k < items.size(); ++k)
        ASSERT_EQ(reversed(results[k].x), sobol1(items[k].x)) << items[k].x;
}

TEST_F(SampleSequence, ScramblingABitLooksOnlyAtTheBitsBelow) {
    // In reversed order, as scrambles are kept: so that a scramble of digits respects strata of every size.
    std::mt19937 random(2);
    std::vector<glm::uvec4> items;
    for (int k = 0; k < 4096; ++k) {
        const auto x = static_cast<std::uint32_t>(random());
        const auto seed = static_cast<std::uint32_t>(random());
        for (std::uint32_t bit = 0; bit < 32; ++bit) {
            items.emplace_back(x, seed, bit, 0);
            items.emplace_back(x ^ (1u << bit), seed, bit, 0);
        }
    }
    const auto results = run(shared::CORE_SCRAMBLE, items);
    for (std::size_t k = 0; k < items.size(); k += 2) {
        const std::uint32_t changed = results[k].x ^ results[k + 1].x;
        ASSERT_EQ(changed & ((2u << items[k].z) - 1u), 1u << items[k].z);
    }
}

// How many points of a 2^m block fall into each elementary interval 2^-a x 2^-(m - a).
void expect_net(std::span<const glm::vec4> block, int m) {
    for (int a = 0; a <= m; ++a) {
        std::set<std::pair<int, int>> cells;
        for (const glm::vec4& p : block)
            cells.emplace(static_cast<int>(std::ldexp(p.x, a)), static_cast<int>(std::ldexp(p.y, m - a)));
        ASSERT_EQ(cells.size(), block.size()) << "2^-" << a << " x 2^-" << m - a;
    }
}

TEST_F(SampleSequence, EveryAlignedBlockOfAPairIsANet) {
    std::vector<glm::uvec4> keys;
    for (std::uint32_t stream = 0; stream < 8; ++stream)
        for (std::uint32_t i = 0; i < 4096; ++i) keys.emplace_back(stream, stream * 977u, i, stream * 6u);
    const auto all = points(keys);
    for (std::size_t stream = 0; stream < 8; ++stream) {
        for (int m = 0; m <= 12; ++m) {
            const std::size_t size = std::size_t{1} << m;
            for (std::size_t block = 0; block < 4096 / size && block < 5; ++block)
                expect_net(std::span(all).subspan(stream * 4096 + block * size, size), m);
        }
    }
}

TEST_F(SampleSequence, EveryAlignedBlockOfASingleDimensionIsStratified) {
    std::vector<glm::uvec4> keys;
    for (std::uint32_t dimension = 0; dimension < 16; ++dimension)
        for (std::uint32_t i = 0; i < 1024; ++i) keys.emplace_back(3, 5, i, dimension);
    const auto all = points(keys);
    for (std::size_t d = 0; d < 16; ++d) {
        for (int m = 0; m <= 10; ++m) {
            std::set<int> cells;
            for (std::size_t i = 0; i < std::size_t{1} << m; ++i)
                cells.insert(static_cast<int>(std::ldexp(all[d * 1024 + i].z, m)));
            ASSERT_EQ(cells.size(), std::size_t{1} << m);
        }
    }
}

TEST_F(SampleSequence, StaysBelowOneAndIsNeverNegative) {
    std::mt19937 random(4);
    std::vector<glm::uvec4> keys;
    for (int k = 0; k < 1'000'000; ++k)
        keys.emplace_back(static_cast<std::uint32_t>(random()), static_cast<std::uint32_t>(random()),
                          static_cast<std::uint32_t>(random()), static_cast<std::uint32_t>(random()) & 255u);
    for (const glm::vec4& p : points(keys)) {
        ASSERT_GE(std::min({p.x, p.y, p.z}), 0.0f);
        ASSERT_LE(std::max({p.x, p.y, p.z}), LARGEST_UNIFORM);
    }
}

// p-value of (a, b) being independent and uniform: a 16 x 16 table.
double independence(const std::vector<float>& a, const std::vector<float>& b) {
    std::vector<double> observed(256);
    for (std::size_t k = 0; k < a.size(); ++k)
        ++observed[static_cast<std::size_t>(a[k] * 16) * 16 + static_cast<std::size_t>(b[k] * 16)];
    const std::vector<double> expected(256, static_cast<double>(a.size()) / 256);
    return chi_square(observed, expected).p;
}

TEST_F(SampleSequence, OneSampleIsUniformAndIndependentOverPixelsSeedsAndDimensions) {
    // Neighbours of a key, where a weak hash would show: same sample, key x and key x + 1.
    constexpr std::size_t COUNT = 1 << 18;
    const glm::uvec4 steps[] = {{0, 1, 0, 0}, {1, 0, 0, 0}, {0, 0, 0, 2}, {0, 0, 0, 1}, {0, 1u << 16, 0, 0}};
    std::size_t tests = 0;
    double least = 1;
    for (const std::uint32_t sample : {0u, 1u, 7u, 100'000u}) {
        for (const glm::uvec4& step : steps) {
            std::vector<glm::uvec4> keys;
            for (std::uint32_t k = 0; k < COUNT; ++k) {
                const glm::uvec4 base(step.x ? k * 2u : 9u, step.x ? 4u : k * 2u, sample, 4);
                keys.push_back(base);
                keys.push_back(base + step);
            }
            const auto all = points(keys);
            std::vector<float> columns[6];
            for (std::size_t k = 0; k < all.size(); k += 2)
                for (std::size_t c = 0; c < 6; ++c)
                    columns[c].push_back(all[k + c / 3][static_cast<int>(c % 3)]);
            for (const auto& [a, b] : {std::pair{0, 1}, {3, 4}, {0, 3}, {1, 4}, {0, 4}, {1, 3}, {2, 5}}) {
                least = std::min(least, independence(columns[a], columns[b]));
                ++tests;
            }
        }
    }
    EXPECT_GT(least, sidak_level(SIGNIFICANCE, tests));
}

TEST_F(SampleSequence, DimensionsOfAPixelAreUncorrelatedOverItsSamples) {
    // Padding works only if pairs are shuffled independently: the mean of the product of two centred
    // dimensions over one pixel's 16 samples has mean 0 over pixels. Its variance lies between that of 16
    // independent points and of 8: samples 2k and 2k + 1 fall into opposite halves of every dimension, so
    // their products agree in part.
    constexpr std::uint32_t PIXELS = 8192;
    constexpr std::uint32_t SAMPLES = 16;
    const std::uint32_t dimensions[] = {shared::DIM_PIXEL, shared::DIM_LENS, shared::DIM_BOUNCE_FIRST,
                                        shared::DIM_BOUNCE_FIRST + shared::DIM_LIGHT,
                                        shared::DIM_BOUNCE_FIRST + shared::DIM_PER_BOUNCE};
    std::vector<glm::uvec4> keys;
    for (const std::uint32_t d : dimensions)
        for (std::uint32_t pixel = 0; pixel < PIXELS; ++pixel)
            for (std::uint32_t i = 0; i < SAMPLES; ++i) keys.emplace_back(1, pixel, i, d);
    const auto all = points(keys);
    const auto at = [&](std::size_t column, std::size_t pixel, std::size_t i) {
        return all[((column / 2) * PIXELS + pixel) * SAMPLES + i][static_cast<int>(column % 2)] - 0.5;
    };
    const std::size_t columns = 2 * std::size(dimensions);
    const double level = sidak_level(SIGNIFICANCE, columns * (columns - 1) / 2);
    for (std::size_t a = 0; a < columns; ++a) {
        for (std::size_t b = a + 1; b < columns; ++b) {
            Moments moments;
            for (std::size_t pixel = 0; pixel < PIXELS; ++pixel) {
                double sum = 0;
                for (std::size_t i = 0; i < SAMPLES; ++i) sum += at(a, pixel, i) * at(b, pixel, i);
                moments.add(sum / SAMPLES);
            }
            EXPECT_GT(mean_p_value(moments, 0), level) << a << " " << b;
            EXPECT_LT(moments.variance(), 1.15 / 144 / (SAMPLES / 2)) << a << " " << b;
        }
    }
}

TEST_F(SampleSequence, IntegratesASmoothFunctionFarBetterThanRandomNumbers) {
    // x y over the square, 64 points: random numbers have variance 7/144/64; Owen 1997 promises O(n^-3 log
    // n).
    constexpr std::uint32_t PIXELS = 2048;
    std::vector<glm::uvec4> keys;
    for (std::uint32_t pixel = 0; pixel < PIXELS; ++pixel)
        for (std::uint32_t i = 0; i < 64; ++i) keys.emplace_back(1, pixel, i, 4);
    const auto all = points(keys);
    Moments moments;
    for (std::size_t pixel = 0; pixel < PIXELS; ++pixel) {
        double sum = 0;
        for (std::size_t i = 0; i < 64; ++i)
            sum += double(all[pixel * 64 + i].x) * double(all[pixel * 64 + i].y);
        moments.add(sum / 64);
    }
    EXPECT_GT(mean_p_value(moments, 0.25), SIGNIFICANCE);
    EXPECT_LT(moments.variance(), 7.0 / 144 / 64 / 200);
}

TEST_F(SampleSequence, BouncesNeverShareADimension) {
    std::set<std::uint32_t> used{shared::DIM_PIXEL, shared::DIM_PIXEL + 1, shared::DIM_LENS,
                                 shared::DIM_LENS + 1};
    const std::uint32_t block[] = {shared::DIM_BSDF,      shared::DIM_BSDF + 1,  shared::DIM_LIGHT,
                                   shared::DIM_LIGHT + 1, shared::DIM_BSDF_LOBE, shared::DIM_LIGHT_PICK,
                                   shared::DIM_ROULETTE};
    for (std::uint32_t bounce = 0; bounce < 64; ++bounce)
        for (const std::uint32_t d : block)
            EXPECT_TRUE(used.insert(shared::DIM_BOUNCE_FIRST + bounce * shared::DIM_PER_BOUNCE + d).second);
}

} // namespace
} // namespace ajar::test
