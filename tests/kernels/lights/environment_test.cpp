// The environment: where its map shows, and what its samples average to. Their density: see
// environment_density_test.cpp.
#include "environment_light.hpp"
#include "support/statistics.hpp"

namespace ajar::test {
namespace {

using namespace shared;

TEST_F(EnvironmentLight, ShowsItsMapWhereDocumented) {
    // Four columns: u = 1/8, 3/8, 5/8, 7/8; the direction of u is (cos, sin)(2 pi (u - 1/2)) in (x, z).
    const double h = std::sqrt(0.5);
    const std::vector<glm::dvec3> middles{{-h, 0, -h}, {h, 0, -h}, {h, 0, h}, {-h, 0, h}};
    for (std::size_t bright = 0; bright < 4; ++bright) {
        Environment e = black(4, 3);
        e.radiance[4 + bright] = glm::vec3(1);
        const std::vector<LightItem> seen = look(e, middles);
        for (std::size_t i = 0; i < 4; ++i)
            EXPECT_NEAR(seen[i].radiance.x, i == bright ? 1 : 0, 1e-4) << bright << i;
    }
    Environment top = black(4, 3);
    std::fill_n(top.radiance.begin(), 4, glm::vec3(1));
    EXPECT_EQ(look(top, {{0, 1, 0}})[0].radiance.x, 1.0f) << "row 0 is at +Y";
    EXPECT_EQ(look(top, {{0, -1, 0}})[0].radiance.x, 0.0f);
}

TEST_F(EnvironmentLight, RotationTurnsTheMapAboutTheVerticalAxis) {
    // +X, the middle of the map, goes to -Z by a quarter turn counter-clockwise as +Y sees it.
    Environment e = black(9, 9);
    e.radiance[4 * 9 + 4] = glm::vec3(1);
    e.rotation = static_cast<float>(PI / 2);
    const std::vector<LightItem> seen = look(e, {{0, 0, -1}, {1, 0, 0}, {0, 0, 1}, {-1, 0, 0}});
    EXPECT_NEAR(seen[0].radiance.x, 1, 1e-4);
    for (std::size_t i = 1; i < 4; ++i) EXPECT_NEAR(seen[i].radiance.x, 0, 1e-4);
    for (const LightItem& item : samples(e, 1000)) EXPECT_LT(item.direction.z, -0.1f);
}

TEST_F(EnvironmentLight, LooksUpBilinearly) {
    std::mt19937 random(4);
    for (const Environment& e : maps()) {
        std::vector<glm::dvec3> directions{{0, 1, 0},  {0, -1, 0},    {1, 0, 0},
                                           {-1, 0, 0}, {-1, 0, 1e-9}, {-1, 0, -1e-9}};
        for (int i = 0; i < 5000; ++i) {
            const glm::dvec3 d(uniform(random) - 0.5, uniform(random) - 0.5, uniform(random) - 0.5);
            directions.push_back(glm::normalize(d));
        }
        const std::vector<LightItem> seen = look(e, directions);
        for (std::size_t i = 0; i < seen.size(); ++i) {
            if (i < 2 && e.width > 1) continue; // any column will do at the poles
            const Texel t = texel_of(e, glm::dvec3(glm::vec3(directions[i])));
            const double expected = lookup(e, t).x;
            EXPECT_NEAR(seen[i].radiance.x, expected, 1e-4 * expected + slack(e, t)) << i;
        }
    }
}

TEST_F(EnvironmentLight, SamplesAverageToTheMapsIrradiance) {
    for (const Environment& e : maps()) {
        const glm::dvec3 normal = glm::normalize(glm::dvec3(0.3, 1, -0.2));
        double expected = 0;
        // Points per texel, even: the lookup bends in its middle.
        const std::uint32_t across = std::max(1200 / e.width, 1u) * 2;
        const std::uint32_t down = std::max(600 / e.height, 1u) * 2;
        for (std::uint32_t y = 0; y < e.height * down; ++y)
            for (std::uint32_t x = 0; x < e.width * across; ++x) {
                const Texel t{(x + 0.5) / across, (y + 0.5) / down};
                const double cosine = std::max(glm::dot(direction(e, t.x, t.y), normal), 0.0);
                expected += lookup(e, t).y * cosine * std::sin(t.y / e.height * PI) * 2 * PI * PI /
                            (1.0 * across * down * e.width * e.height);
            }
        Moments moments;
        for (const LightItem& item : samples(e))
            moments.add(double{item.radiance.y} *
                        std::max(glm::dot(glm::dvec3(item.direction), normal), 0.0) / item.pdf);
        EXPECT_GT(mean_p_value(moments, expected, 2e-4 * expected), sidak_level(SIGNIFICANCE, maps().size()))
            << e.width << ": " << moments.mean() << " for " << expected;
    }
}

TEST_F(EnvironmentLight, RadianceOfASampleIsTheLookupInItsDirection) {
    const Environment e = sunny(64, 32);
    for (const LightItem& item : samples(e, 50000)) {
        const Texel t = texel_of(e, item.direction);
        const double expected = lookup(e, t).x;
        EXPECT_NEAR(item.radiance.x, expected, 1e-4 * expected + slack(e, t));
    }
}

TEST_F(EnvironmentLight, ConstantGivesPiTimesItsRadianceOverAPlane) {
    Environment e;
    e.scale = glm::vec3(0.5f, 1, 2);
    Moments moments;
    std::vector<double> observed(64, 0);
    const std::vector<LightItem> all = samples(e);
    for (const LightItem& item : all) {
        ASSERT_EQ(item.radiance, e.scale);
        ASSERT_NEAR(item.pdf, 1 / (4 * PI), 1e-7);
        moments.add(double{item.radiance.z} * std::max(item.direction.y, 0.0f) / item.pdf);
        const double phi = std::atan2(double{item.direction.z}, double{item.direction.x}) / (2 * PI) + 0.5;
        const auto row =
            std::min(static_cast<std::size_t>((1 + double{item.direction.y}) * 4), std::size_t{7});
        observed[row * 8 + std::min(static_cast<std::size_t>(phi * 8), std::size_t{7})] += 1;
    }
    EXPECT_GT(mean_p_value(moments, 2 * PI, 1e-5), SIGNIFICANCE) << moments.mean();
    const std::vector<double> expected(64, static_cast<double>(all.size()) / 64);
    EXPECT_GT(chi_square(observed, expected).p, SIGNIFICANCE);
    const LightItem seen = look(e, {{0, 0, 1}})[0];
    EXPECT_EQ(seen.radiance, e.scale);
    EXPECT_NEAR(seen.pdf, 1 / (4 * PI), 1e-7);
}

} // namespace
} // namespace ajar::test
