// Where scattering could go wrong: grazing angles, no roughness at all, mirrors, normals bent too far.
#include "bsdf_functions.hpp"
#include "support/statistics.hpp"

#include <cmath>

namespace ajar::test {
namespace {

class BsdfEdges : public BsdfFunctions {
  protected:
    // Directions from straight up to far below the horizon, in an azimuth.
    static std::vector<glm::vec3> extremes() {
        std::vector<glm::vec3> all;
        for (const float z :
             {1.0f, 0.99999994f, 0.5f, 1e-3f, 1e-7f, 1e-20f, 1e-38f, 1e-44f, 0.0f, -1e-44f, -1e-7f, -1.0f})
            for (const float phi : {0.0f, 1.0f, 3.14159265f, 5.0f}) {
                const float r = std::sqrt(std::max(1 - z * z, 0.0f));
                all.emplace_back(r * std::cos(phi), r * std::sin(phi), z);
            }
        return all;
    }
    static constexpr float ALPHAS[] = {0, 1e-20f, 1e-6f, 9.9e-4f, 1e-3f, 1.1e-3f, 0.01f, 0.3f, 1};
};

bool sound(const glm::vec3& v) { return std::isfinite(v.x + v.y + v.z) && v.x >= 0 && v.y >= 0 && v.z >= 0; }

TEST_F(BsdfEdges, EvaluateToFiniteNumbersAndToNothingBelowTheHorizon) {
    std::vector<glm::vec4> directions;
    for (const glm::vec3& wo : extremes())
        for (const glm::vec3& wi : extremes()) {
            directions.emplace_back(wo, 0);
            directions.emplace_back(wi, 0);
        }
    for (const Configuration& c : CONFIGURATIONS) {
        for (const float alpha : ALPHAS) {
            for (const std::uint32_t features : {0u, std::uint32_t(shared::FEATURE_SPECULAR), ALL_FEATURES}) {
                const auto values = eval(c, alpha, directions, features);
                for (std::size_t k = 0; k < values.size(); ++k) {
                    ASSERT_TRUE(sound(glm::vec3(values[k])) && sound(glm::vec3(values[k].w)))
                        << c.name << " " << alpha << " wo " << directions[2 * k].z << " wi "
                        << directions[2 * k + 1].z;
                    const bool below = directions[2 * k].z <= 0 || directions[2 * k + 1].z <= 0;
                    ASSERT_TRUE(!below || values[k] == glm::vec4(0));
                }
            }
        }
    }
}

TEST_F(BsdfEdges, SampleToFiniteNumbers) {
    auto u = uniforms(500, 1);
    for (const float x : {0.0f, 0x1p-24f, 0.5f, LARGEST_UNIFORM})
        for (const float y : {0.0f, 0x1p-24f, 0.5f, LARGEST_UNIFORM})
            for (const float z : {0.0f, 0.5f, LARGEST_UNIFORM}) u.emplace_back(x, y, z, 0);
    for (const Configuration& c : CONFIGURATIONS) {
        for (const float alpha : ALPHAS) {
            for (const glm::vec3& wo : extremes()) {
                if (wo.z > 0 && wo.y < -0.5f) continue; // one azimuth less
                for (const Sampled& s : sample(c, alpha, wo, u)) {
                    ASSERT_TRUE(sound(s.weight) && sound(glm::vec3(s.pdf)))
                        << c.name << " " << alpha << " " << wo.z;
                    ASSERT_TRUE(std::isfinite(s.wi.x + s.wi.y + s.wi.z));
                    ASSERT_NEAR(glm::length(s.wi), 1, 1e-4);
                    ASSERT_TRUE(wo.z > 0 || (s.weight == glm::vec3(0) && s.pdf == 0));
                    // The one-sample model keeps weights below the sum of the lobes' weights over their
                    // shares.
                    ASSERT_LE(std::max({s.weight.x, s.weight.y, s.weight.z}), 30)
                        << c.name << " " << alpha << " " << wo.z;
                }
            }
        }
    }
}

TEST_F(BsdfEdges, SmoothMetalIsAMirror) {
    const Configuration gold{"gold", {1.0f, 0.77f, 0.34f}, 1, glm::vec3(0.04f), 1};
    for (const float alpha : {0.0f, 0.99f * shared::DELTA_ALPHA}) {
        for (const float degrees : ANGLES_DEGREES) {
            const glm::vec3 wo = outgoing(degrees);
            const glm::vec3 fresnel = gold.base_color + (1.0f - gold.base_color) * std::pow(1 - wo.z, 5.0f);
            for (const Sampled& s : sample(gold, alpha, wo, uniforms(100, 2))) {
                ASSERT_EQ(s.delta, 1);
                ASSERT_EQ(s.pdf, 0);
                ASSERT_LT(glm::distance(s.wi, glm::vec3(-wo.x, -wo.y, wo.z)), 1e-6f);
                ASSERT_LT(glm::distance(s.weight, fresnel), 1e-5f);
            }
            // Nothing of it can be evaluated.
            const std::vector<glm::vec4> pair{glm::vec4(wo, 0), glm::vec4(-wo.x, -wo.y, wo.z, 0)};
            EXPECT_EQ(eval(gold, alpha, pair)[0], glm::vec4(0));
        }
    }
}

TEST_F(BsdfEdges, SmoothPlasticIsAMirrorOverAScatteringBase) {
    const Configuration& plastic = CONFIGURATIONS[3];
    for (const float degrees : {0.0f, 50.0f, 85.0f}) {
        const glm::vec3 wo = outgoing(degrees);
        Moments mirrored; // red, of delta samples
        Moments scattered;
        for (const Sampled& s : sample(plastic, 0, wo, uniforms(200'000, 3))) {
            mirrored.add(s.delta != 0 ? s.weight.x : 0);
            scattered.add(s.delta != 0 ? 0 : s.weight.x);
            ASSERT_EQ(s.pdf == 0, s.delta != 0);
        }
        const double fresnel = 0.04 + 0.96 * std::pow(1 - double(wo.z), 5);
        EXPECT_GT(mean_p_value(mirrored, fresnel, 1e-6), sidak_level(SIGNIFICANCE, 6));
        // The base's share, by quadrature of its definition.
        constexpr int STEPS = 400;
        double base = 0;
        for (int i = 0; i < STEPS; ++i) {
            for (int j = 0; j < STEPS;
                 ++j) { // uniform in the cosine's square and azimuth: f cos = f pi per unit
                const double r2 = (i + 0.5) / STEPS;
                const double phi = 6.283185307179586 * (j + 0.5) / STEPS;
                const glm::dvec3 wi(std::sqrt(r2) * std::cos(phi), std::sqrt(r2) * std::sin(phi),
                                    std::sqrt(1 - r2));
                const double cosine = glm::dot(glm::dvec3(wo), glm::normalize(glm::dvec3(wo) + wi));
                base += double(plastic.base_color.x) * (1 - 0.04 - 0.96 * std::pow(1 - cosine, 5));
            }
        }
        EXPECT_GT(mean_p_value(scattered, base / STEPS / STEPS, 1e-4), sidak_level(SIGNIFICANCE, 6))
            << degrees;
    }
}

TEST_F(BsdfEdges, NothingIsAMirrorWithoutTheFeature) {
    for (const Sampled& s : sample(WHITE_METAL, 0, outgoing(40), uniforms(1000, 4), shared::FEATURE_SPECULAR))
        ASSERT_EQ(s.delta, 0);
}

TEST_F(BsdfEdges, AlbedoIsTheBaseColourBelowItsCoat) {
    const auto albedo = [&](const Configuration& c) {
        return glm::vec3(run(shared::BSDF_ALBEDO, c, 0.5f, {}, {glm::vec4(0)}, 1)[0]);
    };
    EXPECT_LT(glm::distance(albedo(LAMBERT), LAMBERT.base_color), 1e-6f);
    EXPECT_LT(glm::distance(albedo(CONFIGURATIONS[2]), CONFIGURATIONS[2].base_color), 1e-6f);
    EXPECT_LT(glm::distance(albedo(CONFIGURATIONS[3]), 0.96f * CONFIGURATIONS[3].base_color + 0.04f), 1e-6f);
}

TEST_F(BsdfEdges, AdaptedNormalsMirrorAboveTheSurfaceAndGoodOnesStay) {
    auto directions = pairs(100'000, 5); // n at 2k, wo at 2k + 1, both above ng = +z
    for (const glm::vec3 n :
         {glm::vec3(0, 0, 1), glm::vec3(1, 0, 0), glm::vec3(0, 0, -1), glm::vec3(0.6f, 0, -0.8f)})
        for (const float z : {1.0f, 0.3f, 1e-3f, 1e-6f}) {
            directions.emplace_back(n, 0);
            directions.emplace_back(-std::sqrt(1 - z * z), 0, z, 0);
        }
    const auto adapted = run(shared::BSDF_SHADING_NORMAL, LAMBERT, 1, {}, directions, directions.size() / 2);
    std::size_t kept = 0;
    for (std::size_t k = 0; k < adapted.size(); ++k) {
        const glm::dvec3 n(directions[2 * k]);
        const glm::dvec3 wo(directions[2 * k + 1]);
        const glm::dvec3 result(adapted[k]);
        ASSERT_NEAR(glm::length(result), 1, 1e-5);
        ASSERT_GT(glm::dot(result, wo), 0);
        const double height = 2 * glm::dot(result, wo) * result.z - wo.z;
        ASSERT_GT(height, std::min(0.9 * wo.z, 0.01) - 1e-5) << k;
        const double before = 2 * glm::dot(n, wo) * n.z - wo.z;
        if (n.z > 0 && glm::dot(n, wo) > 0 && before > 0.0101) {
            ASSERT_EQ(adapted[k], directions[2 * k]);
            ++kept;
        }
        // Bent within the plane of both normals.
        ASSERT_NEAR(glm::dot(result, glm::cross(n, glm::dvec3(0, 0, 1))), 0, 1e-5);
    }
    EXPECT_GT(kept, adapted.size() / 10);
}

} // namespace
} // namespace ajar::test
