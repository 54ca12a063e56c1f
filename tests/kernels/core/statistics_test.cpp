// The statistics that the other tests decide by, against published tables and simulation.
#include "support/statistics.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <random>
#include <vector>

namespace ajar::test {
namespace {

TEST(Statistics, ChiSquareTailAgreesWithPrintedQuantiles) {
    // Abramowitz and Stegun, table 26.8.
    EXPECT_NEAR(chi_square_tail(3.84146, 1), 0.05, 1e-6);
    EXPECT_NEAR(chi_square_tail(18.3070, 10), 0.05, 1e-6);
    EXPECT_NEAR(chi_square_tail(37.5662, 20), 0.01, 1e-6);
    EXPECT_NEAR(chi_square_tail(149.449, 100), 0.001, 1e-7);
    EXPECT_NEAR(chi_square_tail(67.3276, 100), 0.995, 1e-6);
    EXPECT_EQ(chi_square_tail(0, 5), 1);
}

TEST(Statistics, NormalTailAgreesWithPrintedQuantiles) {
    EXPECT_NEAR(normal_two_sided(1.959963985), 0.05, 1e-9);
    EXPECT_NEAR(normal_two_sided(-3.890591886), 1e-4, 1e-12);
}

TEST(Statistics, SidakLevelsCompoundToTheLevel) {
    EXPECT_DOUBLE_EQ(sidak_level(0.01, 1), 0.01);
    EXPECT_NEAR(1 - std::pow(1 - sidak_level(0.01, 50), 50), 0.01, 1e-12);
}

TEST(Statistics, ChiSquareRejectsADieLoadedByTwoPercentAndAcceptsAFairOne) {
    std::mt19937 random(7);
    const std::vector<double> expected(6, 100000.0 / 6);
    for (const double loaded : {0.0, 0.02}) {
        std::vector<double> observed(6);
        std::uniform_real_distribution<double> uniform;
        for (int k = 0; k < 100000; ++k) {
            const auto face = static_cast<std::size_t>(uniform(random) * 6);
            ++observed[uniform(random) < loaded ? 0 : face];
        }
        const double p = chi_square(observed, expected).p;
        EXPECT_EQ(p > SIGNIFICANCE, loaded == 0) << p;
    }
}

TEST(Statistics, ChiSquareRejectsWhatCannotHappen) {
    EXPECT_EQ(chi_square(std::vector<double>{50, 50, 1}, std::vector<double>{50.5, 50.5, 0}).p, 0);
}

TEST(Statistics, ChiSquareIsUniformUnderItsHypothesisEvenWithPooledBins) {
    // p of many fair experiments: about 1 % below 0.01. Most bins are too thin to stand alone.
    std::mt19937 random(11);
    std::vector<double> weights(60);
    for (std::size_t k = 0; k < weights.size(); ++k) weights[k] = std::exp(-0.1 * static_cast<double>(k));
    double sum = 0;
    for (const double w : weights) sum += w;
    std::discrete_distribution<std::size_t> draw(weights.begin(), weights.end());
    std::vector<double> expected;
    for (const double w : weights) expected.push_back(1000 * w / sum);
    int low = 0;
    for (int experiment = 0; experiment < 2000; ++experiment) {
        std::vector<double> observed(weights.size());
        for (int k = 0; k < 1000; ++k) ++observed[draw(random)];
        low += chi_square(observed, expected).p < 0.01 ? 1 : 0;
    }
    EXPECT_NEAR(low, 20, 20); // four and a half standard deviations
}

TEST(Statistics, MomentsOfSmallNumbersOnALargeOffsetKeepTheirDigits) {
    Moments moments;
    for (const double x : {1e9 + 4, 1e9 + 7, 1e9 + 13, 1e9 + 16}) moments.add(x);
    EXPECT_DOUBLE_EQ(moments.mean(), 1e9 + 10);
    EXPECT_DOUBLE_EQ(moments.variance(), 30);
    EXPECT_DOUBLE_EQ(moments.standard_error(), std::sqrt(7.5));
}

TEST(Statistics, MeansOfConstantsMustAgreeExactly) {
    Moments moments;
    for (int k = 0; k < 10; ++k) moments.add(0.5);
    EXPECT_EQ(mean_p_value(moments, 0.5), 1);
    EXPECT_EQ(mean_p_value(moments, 0.50001), 0);
    EXPECT_EQ(mean_p_value(moments, 0.50001, 1e-4), 1);
}

} // namespace
} // namespace ajar::test
