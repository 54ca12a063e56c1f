// The environment: where its map shows, what its samples average to, and that densities are what they claim.
#include "light_functions.hpp"
#include "support/scene_builder.hpp"
#include "support/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ajar::test {
namespace {

using namespace shared;
constexpr double PI = std::numbers::pi;

struct Texel {
    double x = 0; // columns from the left
    double y = 0; // rows from the top
};

// u = atan2(z, x) / 2 pi + 1/2, v = 0 at +Y; `rotation` turns the map about +Y.
Texel texel_of(const Environment& e, glm::dvec3 world) {
    const double c = std::cos(double{e.rotation});
    const double s = std::sin(double{e.rotation});
    // A rotation by r about +Y takes z to x; the map sees the direction turned back.
    const glm::dvec3 d(c * world.x - s * world.z, world.y, s * world.x + c * world.z);
    return {(std::atan2(d.z, d.x) / (2 * PI) + 0.5) * e.width,
            std::atan2(std::hypot(d.x, d.z), d.y) / PI * e.height};
}

glm::dvec3 lookup(const Environment& e, Texel t) {
    const double fx = std::floor(t.x - 0.5);
    const double fy = std::floor(t.y - 0.5);
    const auto at = [&](double x, double y) {
        const auto i = (static_cast<std::int64_t>(x) + e.width) % e.width;
        const auto j = std::clamp<std::int64_t>(static_cast<std::int64_t>(y), 0, e.height - 1);
        return glm::dvec3(e.radiance[static_cast<std::size_t>(j) * e.width + static_cast<std::size_t>(i)]);
    };
    const double wx = t.x - 0.5 - fx;
    const double wy = t.y - 0.5 - fy;
    return glm::dvec3(e.scale) * glm::mix(glm::mix(at(fx, fy), at(fx + 1, fy), wx),
                                          glm::mix(at(fx, fy + 1), at(fx + 1, fy + 1), wx), wy);
}

Environment black(std::uint32_t width, std::uint32_t height) {
    Environment e;
    e.width = width;
    e.height = height;
    e.radiance.resize(std::size_t{width} * height, glm::vec3(0));
    return e;
}

// A dim sky above, black below, a sun of a hundred thousand times the sky in one texel.
Environment sunny(std::uint32_t width, std::uint32_t height) {
    Environment e = black(width, height);
    for (std::uint32_t y = 0; y < height / 2; ++y)
        for (std::uint32_t x = 0; x < width; ++x)
            e.radiance[std::size_t{y} * width + x] =
                glm::vec3(0.2f, 0.3f, 0.5f + 0.5f * static_cast<float>(x) / static_cast<float>(width));
    e.radiance[std::size_t{height / 4} * width + width / 3] = glm::vec3(1e5f, 9e4f, 8e4f);
    e.scale = glm::vec3(1, 2, 0.5f);
    e.rotation = 0.7f;
    return e;
}

// What a place in the map that is off by 1e-5 texels, as float directions are, does to a lookup.
double slack(const Environment& e, Texel t) {
    const bool by_the_sun = e.width == 64 && std::abs(t.x - 64 / 3 - 0.5) < 1.1 && std::abs(t.y - 8.5) < 1.1;
    return by_the_sun ? 20 : 1e-4;
}

// Smooth, coloured, nowhere black; odd sizes.
Environment smooth(std::uint32_t width, std::uint32_t height) {
    Environment e = black(width, height);
    for (std::uint32_t y = 0; y < height; ++y)
        for (std::uint32_t x = 0; x < width; ++x) {
            const glm::vec3 d = environment_direction(x, y, width, height);
            e.radiance[std::size_t{y} * width + x] = glm::vec3(1.1f + d.x, 1.1f + d.y, 1.1f + d.z * d.x);
        }
    e.rotation = -2;
    return e;
}

std::vector<Environment> maps() {
    return {sunny(64, 32), smooth(37, 19), smooth(1, 1), smooth(2, 1),
            smooth(4099, 5)}; // the last has cells of 4 x 4
}

class EnvironmentLight : public LightFunctions {
  protected:
    static Lighting with(const Environment& environment) {
        Lighting lighting;
        lighting.scene.environment = environment;
        return lighting;
    }
    static std::vector<LightItem> look(const Environment& environment,
                                       const std::vector<glm::dvec3>& directions) {
        std::vector<LightItem> items(directions.size());
        for (std::size_t i = 0; i < items.size(); ++i) items[i].direction = glm::vec3(directions[i]);
        return run(LIGHTS_ENVIRONMENT, with(environment), std::move(items));
    }
    static std::vector<LightItem> samples(const Environment& environment, std::size_t count = 400000) {
        return sample(with(environment), 0, glm::vec3(1, 2, 3), count, 21);
    }
    static glm::dvec3 direction(const Environment& e, double x, double y) {
        const double phi = (x / e.width - 0.5) * 2 * PI;
        const double theta = y / e.height * PI;
        const glm::dvec3 d(std::sin(theta) * std::cos(phi), std::cos(theta), std::sin(theta) * std::sin(phi));
        const double c = std::cos(double{e.rotation});
        const double s = std::sin(double{e.rotation});
        return {c * d.x + s * d.z, d.y, c * d.z - s * d.x};
    }
};

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

TEST_F(EnvironmentLight, SamplesFollowTheDensityThatHitsAreGiven) {
    for (const Environment& e : maps()) {
        // Density at the middle of each texel, which it has throughout.
        std::vector<glm::dvec3> middles;
        std::vector<double> expected;
        for (std::uint32_t y = 0; y < e.height; ++y)
            for (std::uint32_t x = 0; x < e.width; ++x) {
                middles.push_back(direction(e, x + 0.5, y + 0.5));
                expected.push_back(2 * PI / e.width *
                                   (std::cos(PI * y / e.height) - std::cos(PI * (y + 1) / e.height)));
            }
        const std::vector<LightItem> densities = look(e, middles);
        const std::vector<LightItem> all = samples(e);
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
            const double dx = std::abs(t.x - std::round(t.x));
            const double dy = std::abs(t.y - std::round(t.y));
            if (dx > 1e-4 && dy > 1e-4) {
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
        EXPECT_GT(test.p, sidak_level(SIGNIFICANCE, maps().size()))
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
