// How counts of shadow rays become shares.
#include "render/learned_visibility.hpp"

#include <gtest/gtest.h>

namespace ajar::test {
namespace {

using namespace shared;

std::vector<VisibilityCount> no_counts() { return std::vector<VisibilityCount>(VISIBILITY_COUNTERS); }

// As the kernels read it.
double visibility(const std::vector<std::uint8_t>& cell, std::uint32_t node) {
    return (cell[node] + 1) / 256.0;
}

TEST(LearnedVisibility, OfACellThatNoRayLeftIsOneEverywhere) {
    const std::vector<std::uint8_t> cell = freeze_cell(no_counts());
    ASSERT_EQ(cell.size(), VISIBILITY_CELL_BYTES);
    for (std::uint32_t node = 0; node < cell.size(); ++node) EXPECT_EQ(visibility(cell, node), 1) << node;
}

TEST(LearnedVisibility, IsTheShareThatArrivedAtEveryLevel) {
    std::vector<VisibilityCount> counts = no_counts();
    // The first half of the clusters is hidden, the second open, but for its last quarter: half open.
    for (std::uint32_t c = 0; c < VISIBILITY_CLUSTERS; ++c) {
        counts[c].traced = 10000;
        counts[c].arrived = c < VISIBILITY_CLUSTERS / 2 ? 0 : c < VISIBILITY_CLUSTERS * 3 / 4 ? 10000 : 5000;
    }
    const std::vector<std::uint8_t> cell = freeze_cell(counts);
    EXPECT_NEAR(visibility(cell, 1), 0.375, 0.005);
    // The root's children are quarters, the second and the last of theirs sixteenths.
    EXPECT_NEAR(visibility(cell, 4), 0, 1 / 64.0);
    EXPECT_NEAR(visibility(cell, 6), 1, 0.005);
    EXPECT_NEAR(visibility(cell, 7), 0.5, 0.005);
    EXPECT_NEAR(visibility(cell, 4 * 6 + 1), 1, 0.005);
    EXPECT_NEAR(visibility(cell, 4 * 7 + 3), 0.5, 0.005);
    EXPECT_NEAR(visibility(cell, 2 * VISIBILITY_CLUSTERS - 1), 0.5, 0.005);
}

TEST(LearnedVisibility, KeepsAChanceForWhatNoRayReached) {
    std::vector<VisibilityCount> counts = no_counts();
    for (VisibilityCount& count : counts) count.traced = 1000000;
    for (const std::uint8_t byte : freeze_cell(counts)) EXPECT_GE((byte + 1) / 256.0, 1 / 64.0);
}

TEST(LearnedVisibility, OfANodeWithoutRaysIsItsParents) {
    std::vector<VisibilityCount> counts = no_counts();
    counts[0] = {5000, 1000};
    const std::vector<std::uint8_t> cell = freeze_cell(counts);
    EXPECT_NEAR(visibility(cell, 1), 0.2, 0.005);
    EXPECT_EQ(cell[7], cell[1]) << "its quarter has no rays";
    EXPECT_EQ(cell[2 * VISIBILITY_CLUSTERS - 1], cell[1]);
    EXPECT_EQ(visibility(cell, 0), 1) << "distant lights are apart";
}

} // namespace
} // namespace ajar::test
