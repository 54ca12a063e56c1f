// Every material of the table, at many widths and angles: samples fall where the density says, weigh f cos /
// pdf, and average to the albedo that quadrature finds.
#include "bsdf_functions.hpp"
#include "support/statistics.hpp"

#include <cmath>

namespace ajar::test {
namespace {

constexpr double PI = 3.14159265358979323846;
constexpr std::size_t SAMPLES = 150'000;
constexpr std::size_t POLAR = 18;
constexpr std::size_t AZIMUTH = 16;

// The coordinates of BSDF_INTEGRATE_*.
glm::dvec2 direction_coordinates(const glm::dvec3& wi) {
    return {std::acos(std::clamp(wi.z, -1.0, 1.0)) * 2 / PI, std::atan2(wi.y, wi.x) / (2 * PI)};
}
glm::dvec2 half_coordinates(const glm::dvec3& wo, const glm::dvec3& wi, double alpha) {
    const glm::dvec3 h = glm::normalize(wo + wi);
    const double width = std::max(alpha, double(shared::DELTA_ALPHA));
    const double theta = std::atan2(std::hypot(h.x, h.y), h.z);
    return {std::log1p(theta / width) / std::log1p(0.5 * PI / width), std::atan2(h.y, h.x) / (2 * PI)};
}

struct Integral {
    std::vector<double> pdf; // by cell
    double pdf_sum = 0;
    double albedo = 0;
};

class BsdfSampling : public BsdfFunctions {
  protected:
    static Integral integrate(std::uint32_t function, const Configuration& c, float alpha,
                              const glm::vec3& wo) {
        std::vector<glm::vec4> cells;
        for (std::size_t t = 0; t < AZIMUTH; ++t)
            for (std::size_t s = 0; s < POLAR; ++s)
                cells.emplace_back(glm::vec2(s, s + 1) / float(POLAR), glm::vec2(t, t + 1) / float(AZIMUTH));
        Integral integral;
        for (const glm::vec4& value : run(function, c, alpha, wo, cells, cells.size())) {
            integral.pdf.push_back(value.y);
            integral.pdf_sum += value.y;
            integral.albedo += value.x;
        }
        return integral;
    }

    // Chi-square of the samples that were not absorbed, over the cells; and their share against the density's
    // integral.
    static double agreement(const std::vector<glm::dvec2>& places, const Integral& integral) {
        std::vector<double> observed(POLAR * AZIMUTH);
        for (glm::dvec2 place : places) {
            place.y -= std::floor(place.y);
            place = glm::clamp(place, 0.0, 1 - 1e-12);
            ++observed[static_cast<std::size_t>(place.y * AZIMUTH) * POLAR +
                       static_cast<std::size_t>(place.x * POLAR)];
        }
        std::vector<double> expected;
        // 1e-6: a cell's corner may hold directions though no point of the quadrature fell there.
        for (const double p : integral.pdf)
            expected.push_back((p / integral.pdf_sum + 1e-6) * static_cast<double>(places.size()));
        return chi_square(observed, expected).p;
    }
};

// Every row, width and angle, but Lambert's one width.
template <class F> void for_each_case(F&& f) {
    for (const Configuration& c : CONFIGURATIONS) {
        for (const float roughness : ROUGHNESSES) {
            if (&c == &CONFIGURATIONS[0] && roughness != 1) continue;
            for (const float degrees : ANGLES_DEGREES) {
                SCOPED_TRACE(c.name + std::string(", roughness ") + std::to_string(roughness) + ", " +
                             std::to_string(degrees) + " degrees");
                f(c, roughness * roughness, degrees);
            }
        }
    }
}
constexpr std::size_t CASES =
    (std::size(CONFIGURATIONS) - 1) * std::size(ROUGHNESSES) * std::size(ANGLES_DEGREES) +
    std::size(ANGLES_DEGREES);

TEST_F(BsdfSampling, FallsWhereTheDensitySaysAndAveragesToTheAlbedo) {
    const auto u = uniforms(SAMPLES, 1);
    for_each_case([&](const Configuration& c, float alpha, float degrees) {
        const glm::vec3 wo = outgoing(degrees);
        const Integral by_half = integrate(shared::BSDF_INTEGRATE_HALF, c, alpha, wo);
        std::vector<glm::dvec2> halves;
        std::vector<glm::dvec2> directions;
        Moments weight;
        Moments present;
        for (const Sampled& s : sample(c, alpha, wo, u)) {
            weight.add(s.weight.x);
            present.add(s.absorbed() ? 0 : 1);
            if (s.absorbed()) continue;
            halves.push_back(half_coordinates(wo, s.wi, alpha));
            directions.push_back(direction_coordinates(s.wi));
        }
        const double level = sidak_level(SIGNIFICANCE, 4 * CASES);
        EXPECT_GT(agreement(halves, by_half), level) << "by half vector";
        // What is not there was absorbed. 3e-4: the quadrature's error, at the edge where reflections leave
        // the surface.
        EXPECT_LE(by_half.pdf_sum, 1 + 3e-4);
        EXPECT_GT(mean_p_value(present, by_half.pdf_sum, 3e-4), level)
            << present.mean() << " " << by_half.pdf_sum;
        EXPECT_GT(mean_p_value(weight, by_half.albedo, 3e-4), level)
            << weight.mean() << " " << by_half.albedo;
        // Cells of directions are too wide for such lobes, which are narrower yet across a grazing plane.
        if (alpha * wo.z < 0.006f) return;
        const Integral by_direction = integrate(shared::BSDF_INTEGRATE_DIRECTION, c, alpha, wo);
        EXPECT_GT(agreement(directions, by_direction), level) << "by direction";
        EXPECT_NEAR(by_direction.albedo, by_half.albedo, 1e-3);
    });
}

TEST_F(BsdfSampling, WeighsFCosOverPdf) {
    const auto u = uniforms(5000, 2);
    for_each_case([&](const Configuration& c, float alpha, float degrees) {
        const glm::vec3 wo = outgoing(degrees);
        const auto samples = sample(c, alpha, wo, u);
        std::vector<glm::vec4> directions;
        for (const Sampled& s : samples) {
            directions.emplace_back(wo, 0);
            directions.emplace_back(s.wi, 0);
        }
        const auto values = eval(c, alpha, directions);
        for (std::size_t k = 0; k < samples.size(); ++k) {
            const Sampled& s = samples[k];
            ASSERT_EQ(s.delta, 0);
            ASSERT_FLOAT_EQ(s.pdf, values[k].w);
            const glm::vec3 expected = s.pdf > 0 ? glm::vec3(values[k]) * (s.wi.z / s.pdf) : glm::vec3(0);
            for (int channel = 0; channel < 3; ++channel)
                ASSERT_NEAR(s.weight[channel], expected[channel], 1e-5f * (1 + expected[channel]));
            ASSERT_NEAR(glm::length(s.wi), 1, 1e-5);
        }
    });
}

TEST_F(BsdfSampling, OfLambertIsPerfect) {
    for (const float degrees : ANGLES_DEGREES) {
        for (const std::uint32_t features : {0u, ALL_FEATURES}) {
            for (const Sampled& s :
                 sample(WHITE_LAMBERT, 1, outgoing(degrees), uniforms(10'000, 3), features)) {
                if (s.absorbed()) continue; // exactly at the horizon
                for (int channel = 0; channel < 3; ++channel) ASSERT_NEAR(s.weight[channel], 1, 3e-7);
            }
        }
    }
}

TEST_F(BsdfSampling, OfMicrofacetsLosesLittleBelowTheSurface) {
    // The plain cap of visible normals loses up to half. The bound is tight where alpha is 1.
    for (const float degrees : ANGLES_DEGREES) {
        for (const float roughness : {0.3f, 0.5f, 0.75f, 1.0f}) {
            std::size_t absorbed = 0;
            const auto u = uniforms(SAMPLES, 4);
            for (const Sampled& s : sample(WHITE_METAL, roughness * roughness, outgoing(degrees), u))
                absorbed += s.absorbed() ? 1 : 0;
            EXPECT_LT(static_cast<double>(absorbed) / SAMPLES, roughness < 1 ? 0.07 : 1e-4) << degrees;
        }
    }
}

} // namespace
} // namespace ajar::test
