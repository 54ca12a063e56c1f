// Densities of an environment map are what they claim to be: of all samples, and in both kinds.
#include "environment_light.hpp"
#include "support/statistics.hpp"

namespace ajar::test {
namespace {

using namespace shared;

class EnvironmentDensities : public EnvironmentLight, public testing::WithParamInterface<EnvironmentDensity> {
  protected:
    // Those that have something to sample: the smallest have nothing above their mean.
    static std::vector<Environment> sampled_maps() {
        std::vector<Environment> all = maps();
        if (GetParam() == EnvironmentDensity::compensated)
            std::erase_if(all, [](const Environment& e) { return e.radiance.size() <= 2; });
        return all;
    }
};
INSTANTIATE_TEST_SUITE_P(Of, EnvironmentDensities,
                         testing::Values(EnvironmentDensity::radiance, EnvironmentDensity::compensated),
                         [](const auto& row) {
                             return row.param == EnvironmentDensity::radiance ? "Radiance" : "Excess";
                         });

TEST_P(EnvironmentDensities, SamplesFollowTheDensityThatHitsAreGiven) {
    for (const Environment& e : sampled_maps()) {
        // Density at the middle of each texel, which it has throughout.
        std::vector<glm::dvec3> middles;
        std::vector<double> expected;
        for (std::uint32_t y = 0; y < e.height; ++y)
            for (std::uint32_t x = 0; x < e.width; ++x) {
                middles.push_back(direction(e, x + 0.5, y + 0.5));
                expected.push_back(2 * PI / e.width *
                                   (std::cos(PI * y / e.height) - std::cos(PI * (y + 1) / e.height)));
            }
        const std::vector<LightItem> densities = look(e, middles, GetParam());
        const std::vector<LightItem> all = samples(e, 400000, GetParam());
        double total = 0;
        for (std::size_t i = 0; i < expected.size(); ++i) total += expected[i] *= densities[i].pdf;
        EXPECT_NEAR(total, 1, 1e-4);
        for (double& x : expected) x *= static_cast<double>(all.size()) / total;

        std::vector<double> observed(expected.size(), 0);
        for (const LightItem& item : all) {
            const Texel t = texel_of(e, item.direction);
            const auto column =
                std::min(static_cast<std::size_t>(std::max(t.x, 0.0)), std::size_t{e.width} - 1);
            const auto row =
                std::min(static_cast<std::size_t>(std::max(t.y, 0.0)), std::size_t{e.height} - 1);
            // Within rounding of a texel's border it may count as either side's.
            const double sine = std::hypot(double{item.direction.x}, double{item.direction.z});
            const double dx = std::abs(t.x - std::round(t.x)) * sine; // columns narrow towards the poles
            const double dy = std::abs(t.y - std::round(t.y));
            if (dx > 1e-4 + e.width * 0x1p-23 && dy > 1e-4) { // a float's column is no finer
                ASSERT_NEAR(item.pdf, densities[row * e.width + column].pdf, 1e-5f * item.pdf);
                observed[row * e.width + column] += 1;
            } else {
                // Where its own density says it came from.
                std::size_t best = row * e.width + column;
                for (const double ox : {-1e-3, 1e-3})
                    for (const double oy : {-1e-3, 1e-3}) {
                        const auto i = static_cast<std::size_t>(t.x + ox + e.width) % e.width;
                        const auto j = std::min(static_cast<std::size_t>(std::max(t.y + oy, 0.0)),
                                                std::size_t{e.height} - 1);
                        if (densities[j * e.width + i].pdf == item.pdf) best = j * e.width + i;
                    }
                observed[best] += 1;
            }
            ASSERT_NEAR(glm::length(item.direction), 1, 1e-5);
        }
        const ChiSquare test = chi_square(observed, expected);
        EXPECT_GT(test.p, sidak_level(SIGNIFICANCE, 2 * maps().size()))
            << e.width << ": " << test.statistic << " / " << test.degrees;
    }
}

TEST_F(EnvironmentLight, SamplesAreUniformWithinTheirTexel) {
    const Environment e = smooth(2, 1); // two texels, each half a sphere
    std::vector<double> observed(2 * 64, 0);
    const std::vector<LightItem> all = samples(e);
    std::vector<double> share(2, 0);
    for (const LightItem& item : all) {
        const Texel t = texel_of(e, item.direction);
        const std::size_t texel = t.x < 1 ? 0 : 1;
        const auto column =
            std::min(static_cast<std::size_t>((t.x - static_cast<double>(texel)) * 8), std::size_t{7});
        const auto row = std::min(static_cast<std::size_t>((1 - double{item.direction.y}) * 4),
                                  std::size_t{7}); // equal areas
        observed[texel * 64 + row * 8 + column] += 1;
        share[texel] += 1;
    }
    std::vector<double> expected(2 * 64);
    for (std::size_t i = 0; i < expected.size(); ++i) expected[i] = share[i / 64] / 64;
    EXPECT_GT(chi_square(observed, expected).p, SIGNIFICANCE);
}

// Nothing above the mean, or nothing at all: no sample has a density, no hit is given one.
TEST_F(EnvironmentLight, ADensityOfNothingSamplesNothing) {
    Environment grey = black(64, 32);
    std::fill(grey.radiance.begin(), grey.radiance.end(), glm::vec3(0.7f));
    for (const auto& [e, density] : {std::pair{grey, EnvironmentDensity::compensated},
                                     std::pair{smooth(1, 1), EnvironmentDensity::compensated},
                                     std::pair{black(37, 19), EnvironmentDensity::compensated},
                                     std::pair{black(37, 19), EnvironmentDensity::radiance}}) {
        std::vector<glm::dvec3> directions;
        for (const LightItem& item : samples(e, 10000, density)) {
            ASSERT_EQ(item.pdf, 0);
            ASSERT_NEAR(glm::length(item.direction), 1, 1e-5);
            directions.emplace_back(item.direction);
        }
        directions.insert(directions.end(), {{0, 1, 0}, {0, -1, 0}, {1, 0, 0}, {-1, 0, 0}, {0, 0, 1}});
        for (const LightItem& item : look(e, directions, density)) {
            ASSERT_EQ(item.pdf, 0);
            ASSERT_NEAR(item.radiance.x, e.radiance[0].x, 1e-6);
        }
    }
}

// All of the sun's light is in its own and the eight cells around it, and nothing else is above the mean.
TEST_F(EnvironmentLight, CompensatedSamplesOfASmallSunAreSamplesOfTheSun) {
    Environment e = black(64, 32);
    std::fill(e.radiance.begin(), e.radiance.end(), glm::vec3(0.5f));
    e.radiance[20 * 64 + 63] = glm::vec3(1e5f); // reaches over the map's border
    double sampled = 0;
    const std::vector<LightItem> all = samples(e, 20000, EnvironmentDensity::compensated);
    for (const LightItem& item : all) {
        ASSERT_GT(item.pdf, 0);
        const Texel t = texel_of(e, item.direction);
        const double across = std::abs(std::remainder(t.x - 63.5, 64));
        ASSERT_LE(across, 1.5 + 1e-3);
        ASSERT_LE(std::abs(t.y - 20.5), 1.5 + 1e-3);
        if (across < 0.5 && std::abs(t.y - 20.5) < 0.5) sampled += 1;
    }
    // The tent's share: (3/4)^2, cells being equal but for their sines.
    EXPECT_NEAR(sampled / static_cast<double>(all.size()), 0.5625, 0.02);
}

} // namespace
} // namespace ajar::test
