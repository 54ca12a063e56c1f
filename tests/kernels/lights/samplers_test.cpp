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
        std::vector<LightItem> items(count);
        for (LightItem& item : items) {
            item.point = 4.0f * glm::vec3(uniform(random), uniform(random), uniform(random));
            item.direction = glm::vec3(0, 1, 0);
            item.uv.x = uniform(random);
        }
        // The ends of the range.
        items[0].uv.x = 0;
        items[1].uv.x = 1 - 0x1p-24f;
        return run(LIGHTS_PICK, lighting, std::move(items));
    }
};

INSTANTIATE_TEST_SUITE_P(All, LightSamplers, testing::Values(LIGHT_SAMPLER_POWER, LIGHT_SAMPLER_UNIFORM),
                         [](const auto& row) {
                             return row.param == LIGHT_SAMPLER_POWER ? "Power" : "Uniform";
                         });

TEST_P(LightSamplers, PickLightsAsOftenAsTheySay) {
    for (const std::size_t triangle_count : {0u, 1u, 12u, 124u, 3000u}) {
        const Lighting lighting = many_lights(triangle_count, GetParam());
        const std::size_t count = triangle_count + 4;
        const std::vector<LightItem> picks = pick(lighting, 400000);
        std::vector<double> observed(count, 0);
        std::vector<double> pmf(count, 0);
        for (const LightItem& item : picks) {
            ASSERT_LT(item.light, count);
            ASSERT_GT(item.pdf, 0.0f);
            ASSERT_EQ(item.pdf, item.distance) << "pick and pmf disagree about light " << item.light;
            observed[item.light] += 1;
            pmf[item.light] = item.pdf;
        }
        // Lights that were never picked: what the table says.
        const LightTable table = lighting.table();
        for (std::size_t i = 0; i < count; ++i)
            if (observed[i] == 0)
                pmf[i] = GetParam() == LIGHT_SAMPLER_UNIFORM ? 1.0 / static_cast<double>(count)
                                                             : double{table.lights[i].power_pmf};
        EXPECT_NEAR(std::accumulate(pmf.begin(), pmf.end(), 0.0), 1, 1e-5);
        for (double& p : pmf) p *= static_cast<double>(picks.size());
        const ChiSquare test = chi_square(observed, pmf);
        EXPECT_GT(test.p, sidak_level(SIGNIFICANCE, 10))
            << triangle_count << " triangles: " << test.statistic;
    }
}

TEST_P(LightSamplers, ReturnARestThatIsUniformAgain) {
    const std::vector<LightItem> picks = pick(many_lights(12, GetParam()), 400000);
    std::vector<double> observed(64, 0);
    for (const LightItem& item : picks) {
        ASSERT_GE(item.direction.x, 0.0f);
        ASSERT_LT(item.direction.x, 1.0f);
        observed[static_cast<std::size_t>(item.direction.x * 64)] += 1;
    }
    const std::vector<double> expected(64, static_cast<double>(picks.size()) / 64);
    EXPECT_GT(chi_square(observed, expected).p, sidak_level(SIGNIFICANCE, 2));
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
