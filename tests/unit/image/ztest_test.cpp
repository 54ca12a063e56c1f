// The z-test is calibrated, finds what it should where it is, and takes rounding for rounding.
#include "folder.hpp"
#include "image/compare.hpp"
#include "image/read.hpp"
#include "image/write.hpp"
#include "image/ztest.hpp"
#include "pictures.hpp"

#include <cmath>
#include <random>

namespace ajar::test {
namespace {

// Pixels of expectation 1 and per-pixel standard deviation between 0.05 and 0.5, known exactly.
class Renders {
  public:
    explicit Renders(std::uint32_t size) : size_(size) {}

    Image next() {
        Image image = flat(size_, size_, {1, 1, 1});
        Layer& variance = image.add("variance", {"R", "G", "B"});
        for (std::size_t i = 0; i < image.pixel_count(); ++i)
            for (std::size_t c = 0; c < 3; ++c) {
                const float deviation = 0.05f + 0.45f * static_cast<float>((7 * i + 3 * c) % 11) / 10;
                image.layers[0].pixels[4 * i + c] += deviation * normal_(random_);
                variance.pixels[3 * i + c] = deviation * deviation;
            }
        return image;
    }

  private:
    std::uint32_t size_;
    std::mt19937 random_{20};
    std::normal_distribution<float> normal_;
};

TEST(ZTest, RejectsEqualExpectationsAsOftenAsItsLevelSays) {
    Renders renders(40); // tiles of 16 are cut at the borders
    constexpr int trials = 500;
    constexpr double level = 0.1;
    for (const BlockSize block : {BlockSize{40, 40}, BlockSize{16, 16}, BlockSize{1, 1}}) {
        int rejected = 0;
        for (int trial = 0; trial < trials; ++trial) {
            const ZTest test = z_test(renders.next(), renders.next(), block, level);
            EXPECT_EQ(test.rejected > 0, test.corrected_p < level);
            rejected += test.rejected > 0;
        }
        const double z = (rejected - trials * level) / std::sqrt(trials * level * (1 - level));
        EXPECT_GT(two_sided_p(z), 1e-4) << block.width << ": " << rejected << " of " << trials;
    }
}

TEST(ZTest, FindsAShiftedTileThatNoPixelShows) {
    Renders renders(64);
    Image a = renders.next(), b = renders.next();
    const Layer& variance = *a.find("variance");
    double total = 0; // of green in the tile at (32, 16)
    const auto for_tile = [&](auto&& action) {
        for (std::size_t y = 16; y < 32; ++y)
            for (std::size_t x = 32; x < 48; ++x) action(y * 64 + x);
    };
    for_tile([&](std::size_t i) { total += 2 * variance.pixels[3 * i + 1]; });
    const float shift =
        static_cast<float>(8 * std::sqrt(total) / 256); // eight standard deviations of the tile's sum
    for_tile([&](std::size_t i) { a.layers[0].pixels[4 * i + 1] += shift; });

    const ZTest tiles = z_test(a, b, {16, 16}, 1e-4);
    EXPECT_EQ(tiles.tests, 48u);
    EXPECT_EQ(tiles.rejected, 1u);
    EXPECT_EQ(tiles.x, 32u);
    EXPECT_EQ(tiles.y, 16u);
    EXPECT_EQ(tiles.channel, 1u);
    EXPECT_NEAR(tiles.z, 8, 4); // plus a standard normal
    EXPECT_LT(tiles.corrected_p, 1e-4);
    EXPECT_EQ(z_test(a, b, {1, 1}, 1e-4).rejected, 0u);
}

TEST(ZTest, FindsABiasOfTheWholeImageThatNoTileShows) {
    Renders renders(128);
    Image a = renders.next(), b = renders.next();
    const Layer& variance = *a.find("variance");
    for (std::size_t i = 0; i < a.pixel_count(); ++i)
        a.layers[0].pixels[4 * i + 2] -= 0.1f * std::sqrt(2 * variance.pixels[3 * i + 2]);
    const ZTest image = z_test(a, b, {128, 128}, 1e-4);
    EXPECT_EQ(image.rejected, 1u);
    EXPECT_EQ(image.channel, 2u);
    EXPECT_LT(image.z, -5);
    EXPECT_EQ(z_test(a, b, {16, 16}, 1e-4).rejected, 0u);
}

TEST(ZTest, FindsASingleWrongPixel) {
    Renders renders(64);
    Image a = renders.next(), b = renders.next();
    b.layers[0].pixels[4 * (5 * 64 + 60)] += 10;
    const ZTest pixels = z_test(a, b, {1, 1}, 1e-4);
    EXPECT_EQ(pixels.rejected, 1u);
    EXPECT_EQ(pixels.x, 60u);
    EXPECT_EQ(pixels.y, 5u);
    EXPECT_EQ(pixels.tests, 3u * 64 * 64);
}

Image without_noise(const glm::vec3& color, float rounding) {
    Image image = flat(32, 32, color);
    image.add("variance", {"R", "G", "B"});
    image.layers[0].rounding = rounding;
    return image;
}

TEST(ZTest, TakesRoundingOfHalfFloatsForNoDifference) {
    // Between 0.5 and 1 half floats are 2^-11 apart: two roundings of one value differ by at most one step.
    const Image a = without_noise(glm::vec3(0.75f), 0x1p-11f);
    for (const std::uint32_t block : {1u, 16u, 32u}) {
        const Image step = without_noise(glm::vec3(0.75f + 0x1p-11f), 0x1p-11f);
        EXPECT_EQ(z_test(a, step, {block, block}, 1e-4).rejected, 0u) << block;
        const Image steps = without_noise(glm::vec3(0.75f + 3 * 0x1p-11f), 0x1p-11f);
        const ZTest wrong = z_test(a, steps, {block, block}, 1e-4);
        EXPECT_EQ(wrong.rejected, wrong.tests) << block;
        // The same step is a difference between 32-bit files.
        EXPECT_GT(z_test(without_noise(glm::vec3(0.75f), 0x1p-24f),
                         without_noise(glm::vec3(0.75f + 0x1p-11f), 0x1p-24f), {block, block}, 1e-4)
                      .rejected,
                  0u);
    }
}

TEST(ZTest, AcceptsAFileOfHalfFloatsForOneOfFullFloats) {
    const Folder folder;
    Image image = flat(48, 48, {0.7001f, 0.1003f, 1e-6f}); // a constant: all pixels round alike
    image.add("variance", {"R", "G", "B"});
    write_image(folder / "half.exr", image);
    write_image(folder / "full.exr", image, {.exr_floats = ExrFloats::full});
    const Comparison comparison = compare(read_image(folder / "half.exr"), read_image(folder / "full.exr"));
    EXPECT_GT(comparison.max_error, 0);
    EXPECT_EQ(comparison.pixel_z->rejected + comparison.tile_z->rejected + comparison.image_z->rejected, 0u);
    EXPECT_TRUE(judge(comparison, {}).same);
}

TEST(Sidak, MatchesKnownValues) {
    EXPECT_NEAR(two_sided_p(1.959964), 0.05, 1e-6); // normal tables
    EXPECT_NEAR(two_sided_p(-3.290527), 0.001, 1e-8);
    EXPECT_NEAR(sidak(0.01, 3), 1 - 0.99 * 0.99 * 0.99, 1e-12);
    EXPECT_NEAR(sidak(1e-20, 1000000) / 1e-14, 1, 1e-9);
    EXPECT_NEAR(sidak(sidak_level(1e-4, 786432), 786432) / 1e-4, 1, 1e-9);
    EXPECT_EQ(sidak(0, 5), 0);
}

} // namespace
} // namespace ajar::test
