// The Sobol sampler: its matrix, Owen's scrambling, and the net property of every pair.
#include "sample_sequence.hpp"

namespace ajar::test {
namespace {

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
                                   shared::DIM_LIGHT + 1, shared::DIM_BSDF_LOBE, shared::DIM_LIGHT_DIGITS,
                                   shared::DIM_ROULETTE};
    for (std::uint32_t bounce = 0; bounce < 64; ++bounce)
        for (const std::uint32_t d : block)
            EXPECT_TRUE(used.insert(shared::DIM_BOUNCE_FIRST + bounce * shared::DIM_PER_BOUNCE + d).second);
}

} // namespace
} // namespace ajar::test
