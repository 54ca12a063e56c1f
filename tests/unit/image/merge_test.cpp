// Merged images: the mean and variance of all samples, however they were divided.
#include "image/merge.hpp"

#include "base/error.hpp"
#include "pictures.hpp"

#include <gtest/gtest.h>
#include <random>

namespace ajar::test {

namespace {

// As the film makes it of these samples of one pixel.
Image film(const std::vector<double>& samples) {
    Image image = flat(1, 1, {0, 0, 0});
    image.add("variance", {"R", "G", "B"});
    double sum = 0, squares = 0;
    for (const double x : samples) sum += x, squares += x * x;
    const auto n = static_cast<double>(samples.size());
    const double variance = n > 1 ? (squares / n - sum / n * sum / n) / (n - 1) : squares;
    for (std::size_t c = 0; c < 3; ++c) {
        image.layers[0].pixels[c] = static_cast<float>(sum / n);
        image.layers[1].pixels[c] = static_cast<float>(variance);
    }
    return image;
}

} // namespace

TEST(SampleMeanTest, IsThatOfAllSamplesHoweverTheyAreDivided) {
    std::mt19937 random(1);
    std::lognormal_distribution<double> bright(0, 1);
    std::vector<double> all;
    for (int i = 0; i < 64; ++i) all.push_back(bright(random));
    const Image whole = film(all);
    for (const std::vector<std::size_t>& cuts :
         {std::vector<std::size_t>{64}, {1, 1, 2, 4, 8, 16, 32}, {63, 1}, {10, 20, 34}}) {
        SampleMean mean;
        std::size_t at = 0;
        for (const std::size_t count : cuts) {
            const auto first = all.begin() + static_cast<std::ptrdiff_t>(at);
            mean.add(film({first, first + static_cast<std::ptrdiff_t>(count)}), count);
            at += count;
        }
        ASSERT_EQ(mean.samples(), 64u);
        const Image merged = mean.image();
        EXPECT_NEAR(merged.layers[0].pixels[1], whole.layers[0].pixels[1], 1e-5);
        EXPECT_NEAR(merged.layers[1].pixels[1], whole.layers[1].pixels[1], 1e-5);
        EXPECT_EQ(merged.layers[0].pixels[3], 1);
    }
}

TEST(SampleMeanTest, OfOneSampleHasItsSquareForVariance) {
    SampleMean mean;
    mean.add(film({3}), 1);
    EXPECT_FLOAT_EQ(mean.image().layers[1].pixels[0], 9);
}

TEST(SampleMeanTest, RefusesOtherSizesAndImagesWithoutVariance) {
    SampleMean mean;
    mean.add(film({1, 2}), 2);
    EXPECT_THROW(mean.add(flat(1, 1, {1, 1, 1}), 1), Error);
    Image wide = flat(2, 1, {1, 1, 1});
    wide.add("variance", {"R", "G", "B"});
    EXPECT_THROW(mean.add(wide, 1), Error);
}

} // namespace ajar::test
