// Which light gets picked: stated probabilities against counts.
#include "light_functions.hpp"
#include "support/statistics.hpp"

#include <cmath>
#include <numeric>

namespace ajar::test {
namespace {

using namespace shared;

// Triangles of very different powers, some without any, then one light of every other kind.
Lighting many_lights(std::size_t triangle_count, std::uint32_t sampler) {
    std::mt19937 random(5);
    Lighting lighting;
    lighting.sampler = sampler;
    for (std::size_t i = 0; i < triangle_count; ++i) {
        EmissiveTriangle t;
        t.p1 = glm::vec3(1, 0, 0);
        t.p2 = glm::vec3(0, 1, 0);
        t.area = 0.5f;
        const auto level = static_cast<float>(random() % 1000) * 1e-3f;
        t.emission = glm::vec3(level < 0.2f ? 0.0f : std::exp(8 * level));
        lighting.triangles.push_back(t);
    }
    lighting.scene.lights.resize(3);
    lighting.scene.lights[0].intensity = glm::vec3(500);
    lighting.scene.lights[1].kind = LightKind::spot;
    lighting.scene.lights[1].intensity = glm::vec3(900);
    lighting.scene.lights[2].kind = LightKind::directional;
    lighting.scene.lights[2].intensity = glm::vec3(90);
    lighting.scene.environment = Environment{};
    return lighting;
}

class LightSamplers : public LightFunctions, public testing::WithParamInterface<std::uint32_t> {
  protected:
    static std::vector<LightItem> pick(const Lighting& lighting, std::size_t count) {
        std::mt19937 random(9);
        std::vector<LightItem> items(count, receiver());
        for (LightItem& item : items) item.uv = {uniform(random), uniform(random)};
        // The ends of the range.
        items[0].uv.x = 0;
        items[1].uv.x = 1 - 0x1p-24f;
        return run(LIGHTS_PICK, lighting, std::move(items));
    }

    // Of each of `count` lights, as seen from the receiver.
    static std::vector<float> pmf(const Lighting& lighting, std::size_t count) {
        std::vector<LightItem> items(count, receiver());
        for (std::size_t i = 0; i < count; ++i) items[i].light = static_cast<std::uint32_t>(i);
        std::vector<float> result;
        for (const LightItem& item : run(LIGHTS_PMF, lighting, std::move(items))) result.push_back(item.pdf);
        return result;
    }

    static LightItem receiver() {
        LightItem item{};
        item.point = glm::vec3(0.3f, -2, 0.7f);
        item.direction = glm::vec3(0, 1, 0);
        return item;
    }
};

INSTANTIATE_TEST_SUITE_P(All, LightSamplers, testing::ValuesIn(all_light_samplers()),
                         [](const auto& row) { return light_samplers()[row.index].name; });

TEST_P(LightSamplers, PickLightsAsOftenAsTheySay) {
    for (const std::size_t triangle_count : {0u, 1u, 12u, 124u, 3000u}) {
        const Lighting lighting = many_lights(triangle_count, GetParam());
        const std::size_t count = triangle_count + 4;
        const std::vector<LightItem> picks = pick(lighting, 400000);
        std::vector<double> observed(count, 0);
        const std::vector<float> probabilities = pmf(lighting, count);
        for (const LightItem& item : picks) {
            ASSERT_LT(item.light, count);
            ASSERT_GT(item.pdf, 0.0f);
            ASSERT_EQ(item.pdf, probabilities[item.light])
                << "pick and pmf disagree about light " << item.light;
            observed[item.light] += 1;
        }
        std::vector<double> expected(probabilities.begin(), probabilities.end());
        EXPECT_NEAR(std::accumulate(expected.begin(), expected.end(), 0.0), 1, 1e-5);
        for (double& p : expected) p *= static_cast<double>(picks.size());
        const ChiSquare test = chi_square(observed, expected);
        EXPECT_GT(test.p, sidak_level(SIGNIFICANCE, 10))
            << triangle_count << " triangles: " << test.statistic;
    }
}

TEST_P(LightSamplers, ReturnARestThatIsUniformAgain) {
    const std::vector<LightItem> picks = pick(many_lights(12, GetParam()), 400000);
    std::vector<double> observed(64, 0);
    for (const LightItem& item : picks) {
        ASSERT_GE(item.uv.x, 0.0f);
        ASSERT_LT(item.uv.x, 1.0f);
        observed[static_cast<std::size_t>(item.uv.x * 64)] += 1;
    }
    const std::vector<double> expected(64, static_cast<double>(picks.size()) / 64);
    EXPECT_GT(chi_square(observed, expected).p, sidak_level(SIGNIFICANCE, 2));
}

TEST_P(LightSamplers, LeaveARestWhoseDigitsCanBeFilledIn) {
    // Of 24 digits the choice among 3000 lights takes twelve: places on a light would lie on a grid.
    const std::vector<LightItem> picks = pick(many_lights(3000, GetParam()), 400000);
    std::vector<double> coarse(64, 0);
    std::vector<double> fine(64, 0); // digits below 2^-16
    for (const LightItem& item : picks) {
        ASSERT_GE(item.uv.y, 0.0f);
        ASSERT_LT(item.uv.y, 1.0f);
        const float shifted = item.uv.y * 0x1p16f;
        coarse[static_cast<std::size_t>(item.uv.y * 64)] += 1;
        fine[static_cast<std::size_t>((shifted - std::floor(shifted)) * 64)] += 1;
    }
    const std::vector<double> expected(64, static_cast<double>(picks.size()) / 64);
    EXPECT_GT(chi_square(coarse, expected).p, sidak_level(SIGNIFICANCE, 2));
    EXPECT_GT(chi_square(fine, expected).p, sidak_level(SIGNIFICANCE, 2));
}

TEST_P(LightSamplers, FindNothingWhereThereIsNothing) {
    Lighting lighting;
    lighting.sampler = GetParam();
    for (const LightItem& item : pick(lighting, 64)) EXPECT_EQ(item.pdf, 0.0f);
}

TEST_F(LightFunctions, PowerSamplerNeverPicksALightWithoutPower) {
    Lighting lighting = many_lights(40, LIGHT_SAMPLER_POWER);
    std::vector<LightItem> items(1u << 18);
    for (std::size_t i = 0; i < items.size(); ++i) items[i].uv.x = static_cast<float>(i) * 0x1p-18f;
    for (const LightItem& item : run(LIGHTS_PICK, lighting, items)) {
        if (item.light < 40) {
            ASSERT_GT(lighting.triangles[item.light].emission.x, 0.0f);
        }
    }
}

} // namespace
} // namespace ajar::test
