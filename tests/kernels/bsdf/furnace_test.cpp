// Energy and symmetry: white furnace, reciprocity, and agreement with appendix B written down in double.
#include "bsdf_functions.hpp"
#include "support/statistics.hpp"

#include <cmath>

namespace ajar::test {
namespace {

constexpr double PI = 3.14159265358979323846;

class BsdfFurnace : public BsdfFunctions {};

// The integral of g(theta, phi) over the hemisphere around the half vectors of wo; fine near the normal,
// where narrow lobes are: tan(theta) = alpha s / (1 - s).
template <class F> double integrate_half_vectors(double alpha, F&& g) {
    constexpr int STEPS = 600;
    double sum = 0;
    for (int i = 0; i < STEPS; ++i) {
        const double s = (i + 0.5) / STEPS;
        const double slope = alpha * s / (1 - s);
        const double cosine = 1 / std::sqrt(1 + slope * slope);
        const double jacobian = slope * cosine * cosine * cosine * alpha / ((1 - s) * (1 - s));
        for (int j = 0; j < STEPS; ++j) {
            const double phi = 2 * PI * (j + 0.5) / STEPS;
            sum += jacobian *
                   g(glm::dvec3(slope * cosine * std::cos(phi), slope * cosine * std::sin(phi), cosine));
        }
    }
    return sum * 2 * PI / (double(STEPS) * STEPS);
}

TEST_F(BsdfFurnace, TheReferencePassesTheWeakWhiteFurnaceTest) {
    // Heitz 2014, equation 82: what the microfacets show to wo is exactly what the surface shows.
    for (const float roughness : ROUGHNESSES) {
        for (const float degrees : ANGLES_DEGREES) {
            const double alpha = roughness * roughness;
            const glm::dvec3 wo(outgoing(degrees));
            const double shown = integrate_half_vectors(alpha, [&](const glm::dvec3& h) {
                return reference_masking(alpha, wo.z) * reference_ggx(alpha, h.z) *
                       std::max(glm::dot(wo, h), 0.0) / wo.z;
            });
            EXPECT_NEAR(shown, 1, 2e-3) << roughness << " " << degrees;
        }
    }
}

TEST_F(BsdfFurnace, MicrofacetsReflectWhatTheReferenceReflectsAndNeverMoreThanArrives) {
    for (const float roughness : ROUGHNESSES) {
        const float alpha = roughness * roughness;
        for (const float degrees : ANGLES_DEGREES) {
            const glm::vec3 wo = outgoing(degrees);
            const double expected = integrate_half_vectors(alpha, [&](const glm::dvec3& h) {
                const double wo_dot_h = glm::dot(glm::dvec3(wo), h);
                const glm::dvec3 wi = 2 * wo_dot_h * h - glm::dvec3(wo);
                if (wo_dot_h <= 0 || wi.z <= 0) return 0.0;
                return 4 * wo_dot_h * reference_bsdf(WHITE_METAL, alpha, glm::dvec3(wo), wi).x * wi.z;
            });
            Moments albedo;
            for (const Sampled& s : sample(WHITE_METAL, alpha, wo, uniforms(100'000, 5)))
                albedo.add(s.weight.x);
            EXPECT_LE(expected, 1 + 1e-3);
            EXPECT_GT(mean_p_value(albedo, expected, 1e-3), sidak_level(SIGNIFICANCE, 30))
                << roughness << " " << degrees << ": " << albedo.mean() << " " << expected;
            EXPECT_LE(albedo.mean(), 1 + 4 * albedo.standard_error());
        }
    }
}

TEST_F(BsdfFurnace, EvaluatesAppendixB) {
    const auto directions = pairs(20'000, 6);
    for (const Configuration& c : CONFIGURATIONS) {
        for (const float roughness : ROUGHNESSES) {
            SCOPED_TRACE(c.name + std::string(" ") + std::to_string(roughness));
            const float alpha = roughness * roughness;
            const auto values = eval(c, alpha, directions);
            for (std::size_t k = 0; k < values.size(); ++k) {
                const glm::dvec3 wo(directions[2 * k]);
                const glm::dvec3 wi(directions[2 * k + 1]);
                const glm::dvec3 expected = reference_bsdf(c, alpha, wo, wi);
                for (int channel = 0; channel < 3; ++channel)
                    ASSERT_NEAR(values[k][channel], expected[channel], 2e-4 * expected[channel] + 1e-7);
            }
        }
    }
}

TEST_F(BsdfFurnace, IsReciprocal) {
    const auto directions = pairs(20'000, 7);
    std::vector<glm::vec4> swapped = directions;
    for (std::size_t k = 0; k < swapped.size(); k += 2) std::swap(swapped[k], swapped[k + 1]);
    for (const Configuration& c : CONFIGURATIONS) {
        for (const float roughness : ROUGHNESSES) {
            SCOPED_TRACE(c.name + std::string(" ") + std::to_string(roughness));
            const auto forth = eval(c, roughness * roughness, directions);
            const auto back = eval(c, roughness * roughness, swapped);
            for (std::size_t k = 0; k < forth.size(); ++k)
                for (int channel = 0; channel < 3; ++channel)
                    ASSERT_NEAR(forth[k][channel], back[k][channel], 1e-5f * forth[k][channel] + 1e-9f);
        }
    }
}

TEST_F(BsdfFurnace, WithoutFresnelADielectricIsLambert) {
    // specularFactor 0: f0 = f90 = 0, whatever the roughness.
    const auto directions = pairs(1000, 8);
    const auto u = uniforms(1000, 9);
    for (const float alpha : {0.0f, 0.01f, 1.0f}) {
        for (const glm::vec4& value : eval(LAMBERT, alpha, directions))
            for (int channel = 0; channel < 3; ++channel)
                ASSERT_FLOAT_EQ(value[channel], LAMBERT.base_color[channel] / float(PI));
        // Code without the specular lobe gives the same.
        const auto with = sample(LAMBERT, alpha, outgoing(50), u);
        const auto without = sample(LAMBERT, alpha, outgoing(50), u, 0);
        for (std::size_t k = 0; k < u.size(); ++k) {
            ASSERT_EQ(with[k].wi, without[k].wi);
            ASSERT_FLOAT_EQ(with[k].pdf, without[k].pdf);
            ASSERT_LT(glm::distance(with[k].weight, without[k].weight), 1e-6f);
        }
    }
}

} // namespace
} // namespace ajar::test
