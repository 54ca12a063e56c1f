// FLIP against values that the papers' equations give in closed form, and against its own definition.
#include "image/compare.hpp"
#include "image/convolve.hpp"
#include "image/flip.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/glm.hpp>
#include <gtest/gtest.h>
#include <numeric>
#include <random>

namespace ajar::test {
namespace {

ColorPlanes paint(std::uint32_t w, std::uint32_t h,
                  const std::function<glm::vec3(std::uint32_t, std::uint32_t)>& color) {
    ColorPlanes image{w, h, {}};
    for (std::uint32_t y = 0; y < h; ++y)
        for (std::uint32_t x = 0; x < w; ++x) {
            const glm::vec3 c = color(x, y);
            for (int k = 0; k < 3; ++k) image.channel[static_cast<std::size_t>(k)].push_back(c[k]);
        }
    return image;
}

ColorPlanes plain(const glm::vec3& color) {
    return paint(24, 24, [&](std::uint32_t, std::uint32_t) { return color; });
}

ColorPlanes noise(unsigned seed, float scale) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> value(0, scale);
    return paint(40, 30, [&](std::uint32_t, std::uint32_t) {
        return glm::vec3(value(random), value(random), value(random));
    });
}

float mean(const Plane& plane) {
    return std::accumulate(plane.begin(), plane.end(), 0.0f) / static_cast<float>(plane.size());
}

constexpr float ppd = DEFAULT_PIXELS_PER_DEGREE;

TEST(LdrFlip, IsZeroForEqualImages) {
    const ColorPlanes image = noise(1, 1);
    EXPECT_EQ(mean(flip_ldr(image, image, ppd)), 0);
}

TEST(LdrFlip, PutsTheLargestColourDifferenceAtOne) {
    // HPG 2020, section 4.1: green and blue are the display's most distant colours and define the maximum.
    for (const float error : flip_ldr(plain({0, 1, 0}), plain({0, 0, 1}), ppd)) ASSERT_NEAR(error, 1, 1e-4f);
}

TEST(LdrFlip, FollowsTheEquationsForBlackAndWhite) {
    // Plain images have no features. |L| differs by 100, chroma by 0, so the colour error is 100^0.7. The
    // largest is 203.30^0.7 (HyAB of Hunt-adjusted green and blue, computed from their published L*a*b*
    // coordinates (87.735, -86.183, 83.180) and (32.297, 79.188, -107.860)); above 0.4 of it, the rest maps
    // to [0.95, 1].
    const double green_a = -86.183 * 0.87735, green_b = 83.180 * 0.87735;
    const double blue_a = 79.188 * 0.32297, blue_b = -107.860 * 0.32297;
    const double largest = std::pow(87.735 - 32.297 + std::hypot(green_a - blue_a, green_b - blue_b), 0.7);
    const double expected = 0.95 + 0.05 * (std::pow(100, 0.7) - 0.4 * largest) / (0.6 * largest);
    for (const float error : flip_ldr(plain({0, 0, 0}), plain({1, 1, 1}), ppd))
        ASSERT_NEAR(error, expected, 1e-4);
}

TEST(LdrFlip, FollowsTheEquationsForTwoGreys) {
    const auto lightness = [](double y) { return 116 * std::cbrt(y) - 16; };
    const double difference = lightness(0.20) - lightness(0.18);
    const double expected = 0.95 * std::pow(difference, 0.7) / (0.4 * std::pow(203.30, 0.7));
    EXPECT_NEAR(mean(flip_ldr(plain(glm::vec3(0.18f)), plain(glm::vec3(0.20f)), ppd)), expected, 1e-3);
}

// Smooth waves with edges and points, phase-shifted between the channels.
ColorPlanes waves(double phase, const std::function<double(double)>& curve) {
    return paint(20, 16, [&](std::uint32_t x, std::uint32_t y) {
        glm::dvec3 color;
        for (int c = 0; c < 3; ++c)
            color[c] = curve(0.5 + 0.5 * std::sin(0.9 * x + 0.35 * (c + 1) * y + phase * (1 + 0.5 * c)));
        return glm::vec3(color);
    });
}

// The expected numbers come from a second implementation: the papers' formulas written down directly in
// Python, in double precision, with two-dimensional kernels that nobody separated.
void expect_errors(const Plane& error, double mean_error, double least, double most, double at_3_2) {
    EXPECT_NEAR(mean(error), mean_error, 2e-4);
    EXPECT_NEAR(*std::min_element(error.begin(), error.end()), least, 5e-4);
    EXPECT_NEAR(*std::max_element(error.begin(), error.end()), most, 5e-4);
    EXPECT_NEAR(error[2 * 20 + 3], at_3_2, 5e-4);
}

TEST(LdrFlip, AgreesWithADirectImplementation) {
    const auto same = [](double value) { return value; };
    expect_errors(flip_ldr(waves(0, same), waves(0.7, same), ppd), 0.513693, 0.147138, 0.910988, 0.286504);
}

TEST(HdrFlip, AgreesWithADirectImplementation) {
    const auto bright = [](double value) { return 8 * value * value * value * value; };
    expect_errors(flip_hdr(waves(0, bright), waves(0.7, bright), ppd), 0.592901, 0.170830, 0.966292,
                  0.338575);
}

TEST(LdrFlip, DoesNotDependOnWhichImageIsTheReference) {
    const ColorPlanes a = noise(2, 1), b = noise(3, 1);
    const Plane ab = flip_ldr(a, b, ppd), ba = flip_ldr(b, a, ppd);
    for (std::size_t i = 0; i < ab.size(); ++i) {
        ASSERT_NEAR(ab[i], ba[i], 1e-5f);
        ASSERT_GT(ab[i], 0);
        ASSERT_LE(ab[i], 1);
    }
}

TEST(LdrFlip, ReachesAsFarAsItsFilters) {
    const ColorPlanes black = paint(64, 64, [](std::uint32_t, std::uint32_t) { return glm::vec3(0); });
    const ColorPlanes dot =
        paint(64, 64, [](std::uint32_t x, std::uint32_t y) { return glm::vec3(x == 32 && y == 32 ? 1 : 0); });
    const Plane error = flip_ldr(black, dot, ppd);
    const auto at = [&](std::size_t x, std::size_t y) { return error[y * 64 + x]; };
    EXPECT_EQ(*std::max_element(error.begin(), error.end()), at(32, 32));
    EXPECT_GT(at(32, 32), 0.3f);
    EXPECT_GT(at(35, 32), 0);
    // Radius: 3 sqrt(0.04 / (2 pi^2)) 67 = 9.05 pixels, rounded up, for the blue-yellow channel.
    EXPECT_NEAR(at(32 + 11, 32), 0, 1e-6f);
    EXPECT_NEAR(at(32, 32 - 11), 0, 1e-6f);
    EXPECT_NEAR(at(35, 32), at(32, 35), 1e-6f);
    EXPECT_NEAR(at(35, 32), at(29, 32), 1e-6f);
}

TEST(LdrFlip, ForgivesPatternsTooFineToSee) {
    const auto checkers = [](std::uint32_t size) {
        return paint(96, 96, [=](std::uint32_t x, std::uint32_t y) {
            return glm::vec3((x / size + y / size) % 2 ? 0.6f : 0.4f);
        });
    };
    const ColorPlanes grey = paint(96, 96, [](std::uint32_t, std::uint32_t) { return glm::vec3(0.5f); });
    const float fine = mean(flip_ldr(grey, checkers(1), ppd)),
                coarse = mean(flip_ldr(grey, checkers(16), ppd));
    EXPECT_LT(fine, 0.25f * coarse);
    // From twice as near the fine pattern is easier to see.
    EXPECT_GT(mean(flip_ldr(grey, checkers(1), ppd / 4)), 2 * fine);
}

TEST(HdrFlip, StartsWhereTheMaximumIsShownAt85PercentAndStopsWhereTheMedianIs) {
    const ColorPlanes image = paint(9, 1, [](std::uint32_t x, std::uint32_t) {
        return glm::vec3(x < 2 ? 64 : x < 7 ? 1 : 0.25); // median 1
    });
    const ExposureRange range = flip_exposures(image);
    const auto shown = [](double luminance) { // ACES by Narkowicz, input scaled by 0.6
        const double x = 0.6 * luminance;
        return x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14);
    };
    EXPECT_NEAR(shown(64 * std::exp2(range.start)), 0.85, 1e-5);
    EXPECT_NEAR(shown(1 * std::exp2(range.stop)), 0.85, 1e-5);
    EXPECT_EQ(range.count, 6); // log2(64)
}

TEST(HdrFlip, IsZeroForEqualImagesAndFiniteForBlackOnes) {
    const ColorPlanes image = noise(4, 50);
    EXPECT_EQ(mean(flip_hdr(image, image, ppd)), 0);
    EXPECT_EQ(mean(flip_hdr(plain(glm::vec3(0)), plain(glm::vec3(0)), ppd)), 0);
    EXPECT_GT(mean(flip_hdr(plain(glm::vec3(0)), plain(glm::vec3(1)), ppd)), 0.5f);
    EXPECT_GT(mean(flip_hdr(plain(glm::vec3(1)), plain(glm::vec3(3e38f)), ppd)), 0.1f);
}

TEST(HdrFlip, DoesNotDependOnTheUnitOfRadiance) {
    ColorPlanes a = noise(5, 20), b = noise(6, 20);
    const Plane before = flip_hdr(a, b, ppd);
    for (ColorPlanes* image : {&a, &b})
        for (Plane& plane : image->channel)
            for (float& value : plane) value *= 1024;
    const Plane after = flip_hdr(a, b, ppd);
    for (std::size_t i = 0; i < before.size(); ++i) ASSERT_NEAR(before[i], after[i], 1e-4f);
}

TEST(HdrFlip, SeesWhatOneExposureHides) {
    // Both are white at the display's exposure, 30 and 60 there; a shorter exposure tells them apart.
    const auto sun = [](float radiance) {
        return paint(48, 48,
                     [=](std::uint32_t x, std::uint32_t) { return glm::vec3(x < 8 ? radiance : 0.5f); });
    };
    EXPECT_EQ(mean(flip_ldr(sun(30), sun(60), ppd)), 0);
    EXPECT_GT(flip_hdr(sun(30), sun(60), ppd)[24 * 48 + 2], 0.1f);
}

TEST(Convolution, EqualsTheSumOverTheWholeWindow) {
    std::mt19937 random(8);
    std::uniform_real_distribution<float> value(-1, 1);
    const std::uint32_t w = 9, h = 7;
    Plane in(w * h), sum(w * h, 10.0f);
    for (float& v : in) v = value(random);
    const std::vector<float> across{0.1f, -0.3f, 0.5f, 0.7f, 0.2f, 0.9f, -1.0f}, down{0.4f, 2.0f, -0.6f};
    add_convolved(in, w, h, across, down, sum);
    for (int y = 0; y < static_cast<int>(h); ++y)
        for (int x = 0; x < static_cast<int>(w); ++x) {
            double expected = 10;
            for (int j = -1; j <= 1; ++j)
                for (int i = -3; i <= 3; ++i) {
                    const int sx = std::clamp(x + i, 0, static_cast<int>(w) - 1);
                    const int sy = std::clamp(y + j, 0, static_cast<int>(h) - 1);
                    expected += double{across[static_cast<std::size_t>(i + 3)]} *
                                double{down[static_cast<std::size_t>(j + 1)]} *
                                double{in[static_cast<std::size_t>(sy) * w + static_cast<std::size_t>(sx)]};
                }
            ASSERT_NEAR(sum[static_cast<std::size_t>(y) * w + static_cast<std::size_t>(x)], expected, 1e-5);
        }
}

} // namespace
} // namespace ajar::test
