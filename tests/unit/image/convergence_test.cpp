// Slopes of errors over samples: exact lines, simulated renderers, and what cannot be fitted.
#include "image/convergence.hpp"
#include "image/relative_error.hpp"
#include "pictures.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace ajar::test {

namespace {

std::vector<ErrorPoint> power_law(double exponent, double relative_error) {
    std::vector<ErrorPoint> points;
    for (int i = 0; i < 7; ++i) {
        const double mse = std::exp2(2 * exponent * i);
        points.push_back({std::exp2(i), mse, relative_error * mse});
    }
    return points;
}

// The relMSE of `pixels` pixels of value 1 whose mean of n samples has the given standard deviation.
ErrorPoint simulate(std::mt19937& random, int pixels, double n, double deviation) {
    std::normal_distribution<double> normal(0, deviation);
    double sum = 0, squares = 0;
    for (int i = 0; i < pixels; ++i) {
        const double e = relative_square(1 + normal(random), 1);
        sum += e, squares += e * e;
    }
    const double mean = sum / pixels;
    return {n, mean, std::sqrt((squares / pixels - mean * mean) / (pixels - 1))};
}

} // namespace

TEST(Slope, OfAPowerLawIsItsExponent) {
    for (const double exponent : {-0.5, -0.75, -1.0, -0.25, 0.0}) {
        const auto fit = fit_slope(power_law(exponent, 0.01));
        ASSERT_TRUE(fit);
        EXPECT_NEAR(fit->slope, exponent, 1e-12);
    }
    EXPECT_EQ(judge(*fit_slope(power_law(-0.5, 0.01))), SlopeVerdict::as_independent);
    EXPECT_EQ(judge(*fit_slope(power_law(-0.75, 0.01))), SlopeVerdict::steeper);
    EXPECT_EQ(judge(*fit_slope(power_law(-0.25, 0.01))), SlopeVerdict::flatter);
}

TEST(Slope, NeedsThreePointsOfUnlikeSamples) {
    EXPECT_FALSE(fit_slope({}));
    EXPECT_FALSE(fit_slope({{1, 1, 0.1}, {2, 0.5, 0.05}}));
    EXPECT_FALSE(fit_slope({{4, 1, 0.1}, {4, 0.5, 0.05}, {4, 0.7, 0.05}}));
    EXPECT_FALSE(fit_slope({{1, 0, 0}, {2, 0, 0}, {4, 0, 0}})) << "no error has no slope";
    EXPECT_FALSE(fit_slope({{1, std::nan(""), 1}, {2, 1, 1}, {4, 1, 1}}));
}

TEST(Slope, StandardErrorCoversTheTruthAsOftenAsItSays) {
    std::mt19937 random(7);
    int outside = 0, alarms = 0;
    constexpr int trials = 400;
    for (int trial = 0; trial < trials; ++trial) {
        std::vector<ErrorPoint> points;
        for (int i = 0; i < 7; ++i)
            points.push_back(simulate(random, 400, std::exp2(i), 0.3 * std::exp2(-0.5 * i)));
        const auto fit = fit_slope(points);
        ASSERT_TRUE(fit);
        outside += std::abs(fit->slope + 0.5) > 2 * fit->standard_error;
        alarms += judge(*fit) != SlopeVerdict::as_independent;
    }
    // At most 4.6 % by the normal distribution, less where the scatter widens the error; 11 % is more than
    // five deviations of the binomial beyond.
    EXPECT_LT(outside, trials * 0.11);
    EXPECT_GT(outside, 0);
    EXPECT_EQ(alarms, 0);
}

TEST(Slope, OfErrorsThatScatterIsLeftUndecided) {
    std::vector<ErrorPoint> points = power_law(-0.5, 0.5);
    EXPECT_EQ(judge(*fit_slope(points)), SlopeVerdict::undecided) << "by their own standard errors";
    points = power_law(-0.5, 0.01);
    for (std::size_t i = 0; i < points.size(); i += 2) points[i].mse *= 4, points[i].standard_error *= 4;
    EXPECT_EQ(judge(*fit_slope(points)), SlopeVerdict::undecided) << "by what they do";
}

TEST(Slope, SeesABiasAndStrata) {
    std::mt19937 random(8);
    std::vector<ErrorPoint> biased, stratified;
    for (int i = 0; i < 9; ++i) {
        biased.push_back(simulate(random, 4000, std::exp2(i), 0.3 * std::exp2(-0.5 * i) + 0.05));
        stratified.push_back(simulate(random, 4000, std::exp2(i), 0.3 * std::exp2(-0.7 * i)));
    }
    EXPECT_EQ(judge(*fit_slope(biased)), SlopeVerdict::flatter);
    EXPECT_EQ(judge(*fit_slope(stratified)), SlopeVerdict::steeper);
}

TEST(RelativeErrorTest, IsTheMeanOverPixelsAndColours) {
    const Image test = flat(4, 3, {1.5f, 2, 0}), reference = flat(4, 3, {1, 2, 0.5f});
    const RelativeError error = relative_error(test, reference);
    EXPECT_NEAR(error.mse, (0.25 / 1.01 + 0 + 0.25 / 0.26) / 3, 1e-12);
    EXPECT_NEAR(error.standard_error, 0, 1e-9) << "all pixels err alike";
    EXPECT_NEAR(error.mean_shift, 0, 1e-12);
    EXPECT_NEAR(relative_error(flat(2, 2, {2, 2, 2}), flat(2, 2, {1, 1, 1})).mean_shift, 1, 1e-12);
    EXPECT_EQ(relative_error(flat(2, 2, {2, 2, 2}), flat(2, 2, {0, 0, 0})).mean_shift, 0);
}

TEST(RelativeErrorTest, RefusesOtherSizes) {
    EXPECT_ANY_THROW(relative_error(flat(2, 2, {1, 1, 1}), flat(2, 3, {1, 1, 1})));
    EXPECT_ANY_THROW(relative_variance(flat(2, 2, {1, 1, 1})));
}

} // namespace ajar::test
