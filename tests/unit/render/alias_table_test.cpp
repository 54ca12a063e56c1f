// Alias tables pick with exactly the probability they state.
#include "render/alias_table.hpp"

#include <cmath>
#include <cstdint>
#include <gtest/gtest.h>
#include <numeric>
#include <random>
#include <vector>

namespace ajar {
namespace {

constexpr double UNITS = PROBABILITY_UNITS;

// What the kernel does with u = k / 2^24 in exact arithmetic: how many of the 2^24 values of u give each
// entry.
std::vector<std::uint64_t> reconstruct(const AliasTable& table, std::size_t count) {
    std::vector<std::uint64_t> units(table.entries.size(), 0);
    const std::uint64_t capacity = PROBABILITY_UNITS / table.entries.size();
    for (std::size_t slot = 0; slot < table.entries.size(); ++slot) {
        // rest = j / capacity < keep for j = 0 .. capacity - 1
        const auto kept = static_cast<std::uint64_t>(
            std::ceil(double{table.entries[slot].keep} * static_cast<double>(capacity)));
        units[slot] += kept;
        units[table.entries[slot].other] += capacity - kept;
    }
    for (std::size_t i = count; i < units.size(); ++i) EXPECT_EQ(units[i], 0u) << "padding is never picked";
    units.resize(count);
    return units;
}

void expect_exact(const std::vector<double>& weights) {
    const AliasTable table = build_alias_table(weights);
    ASSERT_EQ(table.pmf.size(), weights.size());
    const std::vector<std::uint64_t> units = reconstruct(table, weights.size());
    const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
    double positive = 0;
    for (const double w : weights) positive += w > 0 ? 1 : 0;
    std::uint64_t total = 0;
    for (std::size_t i = 0; i < weights.size(); ++i) {
        ASSERT_EQ(double{table.pmf[i]} * UNITS, static_cast<double>(units[i])) << "entry " << i;
        ASSERT_EQ(weights[i] > 0, units[i] > 0) << "entry " << i;
        // One unit each, and the rest by share.
        if (weights[i] > 0) {
            ASSERT_NEAR(static_cast<double>(units[i]), 1 + weights[i] / sum * (UNITS - positive), 1.001);
        }
        total += units[i];
    }
    EXPECT_EQ(total, PROBABILITY_UNITS);
}

TEST(AliasTable, PicksEachEntryWithExactlyItsStatedProbability) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> uniform(0, 1);
    for (const std::size_t count : {1u, 2u, 3u, 5u, 7u, 8u, 63u, 1000u, 4096u, 100003u}) {
        std::vector<double> even(count, 3.5);
        expect_exact(even);
        std::vector<double> spread(count);
        for (double& w : spread) w = std::exp(40 * uniform(random) - 20);
        expect_exact(spread);
        for (double& w : spread) w = uniform(random) < 0.5 ? 0.0 : w;
        spread[count / 2] = 1;
        expect_exact(spread);
    }
}

TEST(AliasTable, NeverDropsALightThatIsTooWeakForItsShare) {
    expect_exact({1e30, 1e-30});
    expect_exact({1e-300, 1e300, 0, 1e-300});
}

TEST(AliasTable, SplitsEvenlyBetweenEqualLights) {
    EXPECT_EQ(build_alias_table(std::vector<double>{2, 2}).pmf, (std::vector<float>{0.5f, 0.5f}));
    EXPECT_EQ(build_alias_table(std::vector<double>{1, 1, 1, 1}).pmf,
              (std::vector<float>{0.25f, 0.25f, 0.25f, 0.25f}));
}

TEST(AliasTable, HasAnEntryToReadEvenWithoutAnyWeight) {
    EXPECT_EQ(build_alias_table({}).entries.size(), 1u);
    const AliasTable dark = build_alias_table(std::vector<double>{0, 0, 0});
    EXPECT_EQ(dark.entries.size(), 4u);
    EXPECT_EQ(dark.pmf, (std::vector<float>{0, 0, 0}));
    for (const shared::AliasEntry& entry : dark.entries) EXPECT_LT(entry.other, 4u);
}

TEST(Apportion, GivesTheWholeTotalAndNothingToZeroes) {
    const std::vector<double> weights{0, 1, 0, 2, 3, 0, 1e-12};
    const std::vector<std::uint32_t> masses = apportion(weights, 1000);
    EXPECT_EQ(std::accumulate(masses.begin(), masses.end(), 0u), 1000u);
    EXPECT_EQ(masses[0] + masses[2] + masses[5], 0u);
    EXPECT_GE(masses[6], 1u);
    EXPECT_LE(masses[6], 2u);
    EXPECT_NEAR(masses[4], 498.0 + 1, 1.0);
}

} // namespace
} // namespace ajar
