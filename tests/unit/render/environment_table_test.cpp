// Environment tables: densities that integrate to one and follow the bilinear lookup.
#include "base/error.hpp"
#include "render/alias_table.hpp"
#include "render/environment_table.hpp"

#include <bit>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <random>

namespace ajar {
namespace {

constexpr double PI = std::numbers::pi;

Environment random_map(std::uint32_t width, std::uint32_t height) {
    std::mt19937 random(width * 131 + height);
    std::uniform_real_distribution<float> uniform(0, 1);
    Environment e;
    e.width = width;
    e.height = height;
    e.radiance.resize(std::size_t{width} * height);
    for (glm::vec3& texel : e.radiance) {
        const float level = uniform(random) < 0.3f ? 0.0f : std::exp(6 * uniform(random));
        texel = level * glm::vec3(uniform(random), uniform(random), uniform(random));
    }
    return e;
}

double density(const EnvironmentTable& table, std::uint32_t x, std::uint32_t y) {
    return std::bit_cast<float>(table.words[std::size_t{y} * table.width + x].w);
}

double texel_solid_angle(std::uint32_t width, std::uint32_t height, std::uint32_t y) {
    return 2 * PI / width * (std::cos(PI * y / height) - std::cos(PI * (y + 1) / height));
}

double luminance_at(const Environment& e, std::int64_t x, std::int64_t y) {
    x = (x + e.width) % e.width;
    y = std::clamp<std::int64_t>(y, 0, e.height - 1);
    const glm::vec3& c = e.radiance[static_cast<std::size_t>(y) * e.width + static_cast<std::size_t>(x)];
    return 0.2126 * c.x + 0.7152 * c.y + 0.0722 * c.z;
}

// Mean of the bilinear lookup over a texel by the midpoint rule, which is exact for what is linear in each
// quarter.
double mean_lookup(const Environment& e, std::int64_t x, std::int64_t y) {
    double sum = 0;
    for (const double v : {-0.25, 0.25})
        for (const double u : {-0.25, 0.25}) {
            const std::int64_t dx = u < 0 ? -1 : 1;
            const std::int64_t dy = v < 0 ? -1 : 1;
            sum += (0.75 * luminance_at(e, x, y) + 0.25 * luminance_at(e, x + dx, y)) * 0.75 +
                   (0.75 * luminance_at(e, x, y + dy) + 0.25 * luminance_at(e, x + dx, y + dy)) * 0.25;
        }
    return sum / 4;
}

// The tree's lookup in plain words: the entry whose interval of the cumulative sum holds `target`.
std::uint32_t walk(const std::vector<glm::uvec4>& words, std::size_t first, std::uint32_t rows,
                   std::uint32_t row, std::uint32_t count, std::uint32_t target) {
    std::uint32_t level = 1;
    while (std::pow(8.0, level) < count) ++level;
    std::uint32_t index = 0;
    for (; level > 0; --level) {
        const auto span = static_cast<std::uint32_t>(std::pow(8.0, level));
        const std::uint32_t nodes = (count + span - 1) / span;
        const glm::uvec4 begins = words[first + std::size_t{row} * nodes + index];
        std::uint32_t child = 7;
        while (child > 0 && (begins[static_cast<int>(child / 2)] >> (child % 2 * 16) & 0xffff) > target)
            --child;
        index = 8 * index + child;
        first += std::size_t{rows} * nodes;
    }
    return index;
}

EnvironmentTable compensated(const Environment& e) {
    return build_environment_table(e, EnvironmentDensity::compensated);
}

Environment uniform_map(std::uint32_t width, std::uint32_t height, float radiance) {
    Environment e;
    e.width = width;
    e.height = height;
    e.radiance.assign(std::size_t{width} * height, glm::vec3(radiance));
    return e;
}

// Sum of density times solid angle over all texels.
double total(const EnvironmentTable& table) {
    double sum = 0;
    for (std::uint32_t y = 0; y < table.height; ++y)
        for (std::uint32_t x = 0; x < table.width; ++x)
            sum += density(table, x, y) * texel_solid_angle(table.width, table.height, y);
    return sum;
}

TEST(EnvironmentTable, DensityIntegratesToOneOverTheSphere) {
    for (const auto& [width, height] :
         {std::pair{1u, 1u}, {2u, 1u}, {5u, 3u}, {64u, 32u}, {257u, 128u}, {4097u, 3u}})
        EXPECT_NEAR(total(build_environment_table(random_map(width, height))), 1, 1e-6)
            << width << " x " << height;
}

TEST(EnvironmentTable, DensityIsInProportionToTheMeanOfTheBilinearLookup) {
    const Environment e = random_map(64, 32);
    const EnvironmentTable table = build_environment_table(e);
    double sum = 0;
    std::vector<double> rows(32, 0);
    for (std::uint32_t y = 0; y < 32; ++y) {
        for (std::uint32_t x = 0; x < 64; ++x) rows[y] += mean_lookup(e, x, y) * texel_solid_angle(64, 32, y);
        sum += rows[y];
    }
    for (std::uint32_t y = 0; y < 32; ++y)
        for (std::uint32_t x = 0; x < 64; ++x) {
            const double expected = mean_lookup(e, x, y) / sum;
            // Conditional and marginal are each off by up to two units and the one that every positive entry
            // gets.
            const double row = rows[y] / sum;
            const double in_row = expected * texel_solid_angle(64, 32, y) / row;
            const double relative = 3.0 / 65536 / row + 3.0 / 65536 / in_row + 32.0 / 65536 + 64.0 / 65536;
            EXPECT_NEAR(density(table, x, y), expected, relative * expected) << x << ", " << y;
        }
}

TEST(EnvironmentTable, CompensatedDensityIsInProportionToWhatIsAboveTheMean) {
    const Environment e = random_map(64, 32);
    const EnvironmentTable table = compensated(e);
    EXPECT_NEAR(total(table), 1, 1e-6);
    double light = 0;
    for (std::uint32_t y = 0; y < 32; ++y)
        for (std::uint32_t x = 0; x < 64; ++x) light += mean_lookup(e, x, y) * texel_solid_angle(64, 32, y);
    const auto excess = [&](std::uint32_t x, std::uint32_t y) {
        return std::max(mean_lookup(e, x, y) - light / (4 * PI), 0.0);
    };
    double sum = 0;
    std::vector<double> rows(32, 0);
    for (std::uint32_t y = 0; y < 32; ++y) {
        for (std::uint32_t x = 0; x < 64; ++x) rows[y] += excess(x, y) * texel_solid_angle(64, 32, y);
        sum += rows[y];
    }
    EXPECT_NEAR(table.share, sum / light, 1e-9);
    for (std::uint32_t y = 0; y < 32; ++y)
        for (std::uint32_t x = 0; x < 64; ++x) {
            const double expected = excess(x, y) / sum;
            ASSERT_EQ(density(table, x, y) > 0, expected > 0) << x << ", " << y;
            if (expected == 0) continue;
            const double row = rows[y] / sum; // as above
            const double in_row = expected * texel_solid_angle(64, 32, y) / row;
            const double relative = 3.0 / 65536 / row + 3.0 / 65536 / in_row + 32.0 / 65536 + 64.0 / 65536;
            EXPECT_NEAR(density(table, x, y), expected, relative * expected) << x << ", " << y;
        }
}

TEST(EnvironmentTable, CompensatedDensityOfAConstantMapIsNothing) {
    for (const auto& [width, height] : {std::pair{1u, 1u}, {64u, 32u}, {4099u, 7u}})
        for (const float radiance : {0.0f, 0.1f, 3e9f}) {
            const EnvironmentTable table = compensated(uniform_map(width, height, radiance));
            EXPECT_EQ(table.share, 0);
            EXPECT_EQ(total(table), 0) << width << " x " << height << " of " << radiance;
        }
}

TEST(EnvironmentTable, CompensatedDensityKeepsASmallSun) {
    Environment e = uniform_map(4099, 512, 0.5f); // cells of 4 x 4
    e.radiance[100 * 4099 + 4097] = glm::vec3(1e6f);
    const EnvironmentTable table = compensated(e);
    EXPECT_NEAR(total(table), 1, 1e-6);
    for (std::uint32_t y = 0; y < 512; ++y)
        for (std::uint32_t x = 0; x < 4099; ++x)
            ASSERT_EQ(density(table, x, y) > 0, y / 4 >= 24 && y / 4 <= 25 && x >= 4096) << x << ", " << y;
}

// Where no light is, inversion still has to end in a cell that is there.
TEST(EnvironmentTable, TreesOfADensityOfNothingEndInTheirFirstEntry) {
    for (const EnvironmentTable& table :
         {compensated(uniform_map(64, 32, 1)), build_environment_table(uniform_map(64, 32, 0))}) {
        const std::size_t first = std::size_t{64} * 32;
        const std::size_t columns = first + 1 + 4; // levels of 1 and 4 nodes over 32 rows
        for (const std::uint32_t target : {0u, 1000u, 65534u}) {
            EXPECT_EQ(walk(table.words, first, 1, 0, 32, target), 0u);
            EXPECT_EQ(walk(table.words, columns, 32, 0, 64, target), 0u);
        }
    }
}

TEST(EnvironmentTable, DensityIsPositiveWhereverTheLookupIs) {
    Environment e = random_map(32, 16);
    for (glm::vec3& texel : e.radiance) texel = glm::vec3(0);
    e.radiance[5 * 32 + 31] = glm::vec3(0, 0, 1e-20f);
    e.radiance[9 * 32 + 4] = glm::vec3(1e9f);
    const EnvironmentTable table = build_environment_table(e);
    for (std::uint32_t y = 0; y < 16; ++y)
        for (std::uint32_t x = 0; x < 32; ++x)
            EXPECT_EQ(density(table, x, y) > 0, mean_lookup(e, x, y) > 0) << x << ", " << y;
}

TEST(EnvironmentTable, GathersTheTexelsOfALargeMapIntoCells) {
    const std::uint32_t width = 4099;
    Environment e = random_map(width, 7);
    for (glm::vec3& texel : e.radiance) texel = glm::vec3(0);
    e.radiance[5 * width + 4096] = glm::vec3(2);
    const EnvironmentTable table = build_environment_table(e);
    EXPECT_EQ(table.cell_shift, 2u);
    EXPECT_NEAR(total(table), 1, 1e-6);
    // Lit: columns 4095 to 4097 and rows 4 to 6, so cells 1023 and 1024 (three texels wide) of row 1.
    double cells = 0;
    for (std::uint32_t y = 0; y < 7; ++y)
        for (std::uint32_t x = 0; x < width; ++x) {
            EXPECT_EQ(density(table, x, y) > 0, y >= 4 && x >= 4092) << x << ", " << y;
            EXPECT_EQ(density(table, x, y), density(table, x - x % 4, y - y % 4));
            if (x >= 4096) cells += density(table, x, y) * texel_solid_angle(width, 7, y);
        }
    EXPECT_NEAR(cells, 0.875, 1e-4) << "an eighth reaches over into column 4095";
}

TEST(EnvironmentTable, MassesLeaveTheLastUnitsToOneEntry) {
    const std::vector<std::uint32_t> masses = environment_masses(std::vector<double>{1, 1e9, 0, 1, 0});
    EXPECT_EQ(masses[0] + masses[1] + masses[3], 65536u);
    EXPECT_GE(masses[3], 2u);
    EXPECT_EQ(masses[2] + masses[4], 0u);
    EXPECT_EQ(environment_masses(std::vector<double>{0, 0}), (std::vector<std::uint32_t>{0, 0}));
}

TEST(EnvironmentTable, TreesFindEveryEntryOverExactlyItsInterval) {
    std::mt19937 random(7);
    for (const std::uint32_t count : {1u, 2u, 7u, 8u, 9u, 64u, 65u, 100u, 512u, 1000u, 2048u}) {
        const std::uint32_t rows = 3;
        std::vector<std::uint32_t> masses;
        for (std::uint32_t row = 0; row < rows; ++row) {
            std::vector<double> weights(count);
            for (double& w : weights) w = random() % 3 == 0 ? 0.0 : static_cast<double>(random() % 100000);
            weights[row == 1 ? 0 : count - 1] += 1;
            const std::vector<std::uint32_t> some = environment_masses(weights);
            masses.insert(masses.end(), some.begin(), some.end());
        }
        std::vector<glm::uvec4> words(11);
        append_search_trees(words, masses, rows, count);
        for (std::uint32_t row = 0; row < rows; ++row) {
            std::uint32_t begin = 0;
            for (std::uint32_t i = 0; i < count; ++i) {
                const std::uint32_t mass = masses[std::size_t{row} * count + i];
                if (mass > 0) {
                    EXPECT_EQ(walk(words, 11, rows, row, count, begin), i);
                    // Kernels never look for the last unit.
                    EXPECT_EQ(walk(words, 11, rows, row, count, std::min(begin + mass - 1, 65534u)), i);
                }
                begin += mass;
            }
            EXPECT_EQ(begin, 65536u);
        }
    }
}

TEST(EnvironmentTable, TreatsBrokenTexelsAsBlack) {
    Environment e = random_map(8, 4);
    for (glm::vec3& texel : e.radiance) texel = glm::vec3(NAN, -1, 0);
    e.radiance[3].y = INFINITY;
    const EnvironmentTable table = build_environment_table(e);
    for (std::uint32_t y = 0; y < 4; ++y)
        for (std::uint32_t x = 0; x < 8; ++x) {
            const glm::vec4 word = std::bit_cast<glm::vec4>(table.words[y * 8 + x]);
            for (int c = 0; c < 4; ++c) EXPECT_TRUE(std::isfinite(word[c]) && word[c] >= 0);
        }
}

TEST(EnvironmentTable, IsEmptyForAConstantAndRefusesAbsurdSizes) {
    EXPECT_TRUE(build_environment_table(Environment{}).words.empty());
    Environment e;
    e.width = 65537;
    e.height = 1;
    e.radiance = std::vector<glm::vec3>(65537, glm::vec3(1));
    EXPECT_THROW(build_environment_table(e), Error);
}

TEST(EnvironmentTable, MeanRadianceWeighsTexelsBySolidAngle) {
    Environment e;
    e.scale = glm::vec3(2, 1, 0.5f);
    EXPECT_EQ(mean_radiance(e), glm::dvec3(2, 1, 0.5));
    // L = cos^2 of the angle from +Y: mean 1/3.
    e.width = 4;
    e.height = 512;
    for (std::uint32_t y = 0; y < e.height; ++y)
        for (std::uint32_t x = 0; x < e.width; ++x) {
            const double c = std::cos(PI * (y + 0.5) / e.height);
            e.radiance.emplace_back(static_cast<float>(c * c));
        }
    EXPECT_NEAR(mean_radiance(e).x, 2.0 / 3, 1e-5);
    EXPECT_NEAR(mean_radiance(e).z, 0.5 / 3, 1e-5);
}

} // namespace
} // namespace ajar
