// Every warp and pixel filter: where its points fall against the density it claims (chi-square over a grid),
// what it does at the ends of the unit interval.
#include "core_functions.hpp"
#include "support/statistics.hpp"

#include <cmath>
#include <functional>

namespace ajar::test {
namespace {

constexpr double PI = 3.14159265358979323846;
constexpr std::size_t SAMPLES = 1'000'000;

// How to test a warp: coordinates (s, t) in [0, 1]^2 of a point, in which `probability` gives the mass of a
// cell.
struct Domain {
    const char* name;
    std::uint32_t function;
    float parameter;
    std::function<glm::dvec2(glm::dvec3)> coordinates;
    std::function<double(double, double)> density; // of (s, t); integrates to 1
    std::function<double(glm::dvec3)> pdf;         // what the warp must report at a point
};

double azimuth(const glm::dvec3& p) { return std::atan2(p.y, p.x) / (2 * PI) + 0.5; }
double flat(double, double) { return 1; }

std::vector<Domain> domains() {
    const auto cap = [](double h) {
        return [h](glm::dvec3 p) { return glm::dvec2((p.x * p.x + p.y * p.y) / (1 + p.z) / h, azimuth(p)); };
    };
    const auto by_height = [](glm::dvec3 p) { return glm::dvec2((1 - p.z) / 2, azimuth(p)); };
    std::vector<Domain> all{
        {"disk", shared::CORE_DISK, 0,
         [](glm::dvec3 p) { return glm::dvec2(p.x * p.x + p.y * p.y, azimuth(p)); }, flat,
         [](glm::dvec3) { return 1 / PI; }},
        {"cosine hemisphere", shared::CORE_COSINE_HEMISPHERE, 0,
         [](glm::dvec3 p) { return glm::dvec2(1 - p.z, azimuth(p)); },
         [](double s, double) { return 2 * (1 - s); }, [](glm::dvec3 p) { return p.z / PI; }},
        {"sphere", shared::CORE_SPHERE, 0, by_height, flat, [](glm::dvec3) { return 0.25 / PI; }},
        {"hemisphere", shared::CORE_HEMISPHERE, 0,
         [](glm::dvec3 p) { return glm::dvec2(1 - p.z, azimuth(p)); }, flat,
         [](glm::dvec3) { return 0.5 / PI; }},
        // Barycentric weights: the square root unfolds the triangle to a square.
        {"triangle", shared::CORE_TRIANGLE, 0,
         [](glm::dvec3 p) {
             const double w = 1 - p.x - p.y;
             return glm::dvec2((1 - w) * (1 - w), p.x / std::max(1 - w, 1e-300));
         },
         flat, [](glm::dvec3) { return 2.0; }},
    };
    for (const float h : {2.0f, 0.5f, 1e-3f, 1e-9f}) {
        all.push_back({"cone", shared::CORE_CONE, h, cap(h), flat, [h](glm::dvec3) { return 0.5 / PI / h; }});
    }
    return all;
}

class Warps : public CoreFunctions {};

TEST_F(Warps, PutTheirPointsWhereTheirDensitySays) {
    constexpr std::size_t CELLS = 32;
    const std::vector<Domain> all = domains();
    for (const Domain& domain : all) {
        SCOPED_TRACE(domain.name + std::string(" ") + std::to_string(domain.parameter));
        const auto points = run(domain.function, uniform_points(SAMPLES, 1), glm::vec4(domain.parameter));
        std::vector<double> observed(CELLS * CELLS);
        for (const glm::vec4& p : points) {
            const glm::dvec2 st =
                glm::clamp(domain.coordinates(glm::dvec3(p)), 0.0, 1 - 1e-12) * double(CELLS);
            ++observed[static_cast<std::size_t>(st.y) * CELLS + static_cast<std::size_t>(st.x)];
        }
        std::vector<double> expected;
        for (std::size_t k = 0; k < CELLS * CELLS; ++k) {
            // The densities are linear in s, so the middle gives the cell's mass exactly.
            const double s = (static_cast<double>(k % CELLS) + 0.5) / CELLS;
            const double t = (static_cast<double>(k / CELLS) + 0.5) / CELLS;
            expected.push_back(domain.density(s, t) * SAMPLES / (CELLS * CELLS));
        }
        EXPECT_GT(chi_square(observed, expected).p, sidak_level(SIGNIFICANCE, all.size()));
    }
}

TEST_F(Warps, ReportTheirDensity) {
    for (const Domain& domain : domains()) {
        SCOPED_TRACE(domain.name);
        for (const glm::vec4& p :
             run(domain.function, uniform_points(1000, 2), glm::vec4(domain.parameter))) {
            const double pdf = domain.pdf(glm::dvec3(p));
            ASSERT_NEAR(p.w, pdf, 1e-5 * pdf);
        }
    }
}

TEST_F(Warps, StayInTheirDomainAtTheEndsOfTheUnitInterval) {
    std::vector<glm::vec4> corners;
    for (const float x : {0.0f, 0x1p-24f, 0.25f, 0.5f, 0.75f, LARGEST_UNIFORM})
        for (const float y : {0.0f, 0x1p-24f, 0.25f, 0.5f, 0.75f, LARGEST_UNIFORM})
            corners.emplace_back(x, y, 0, 0);
    for (const Domain& domain : domains()) {
        SCOPED_TRACE(domain.name);
        for (const glm::vec4& p : run(domain.function, corners, glm::vec4(domain.parameter))) {
            ASSERT_TRUE(std::isfinite(p.x + p.y + p.z + p.w));
            const double r = glm::length(glm::dvec3(p));
            switch (domain.function) {
            case shared::CORE_DISK: ASSERT_LE(r, 1 + 1e-6); break;
            case shared::CORE_TRIANGLE: ASSERT_TRUE(p.x >= 0 && p.y >= 0 && p.x + p.y <= 1); break;
            case shared::CORE_COSINE_HEMISPHERE:
            case shared::CORE_HEMISPHERE: ASSERT_GE(p.z, 0); [[fallthrough]];
            default: ASSERT_NEAR(r, 1, 1e-6);
            }
        }
    }
}

// One axis of a filter on [-1, 1]: its integral from -1 to x, by its definition.
double box_mass(double x) { return 0.5 + 0.5 * x; }
double gaussian_mass(double x) {
    return 0.5 + 0.5 * std::erf(x * 3 / std::sqrt(2.0)) / std::erf(3 / std::sqrt(2.0));
}
double blackman_harris_mass(double x) {
    const double t = 0.5 + 0.5 * x;
    const double sum = 0.35875 * t - 0.48829 * std::sin(2 * PI * t) / (2 * PI) +
                       0.14128 * std::sin(4 * PI * t) / (4 * PI) - 0.01168 * std::sin(6 * PI * t) / (6 * PI);
    return sum / 0.35875;
}

TEST_F(Warps, FiltersPutTheirPointsInProportionToTheFilter) {
    constexpr std::size_t CELLS = 24;
    const struct {
        std::uint32_t function;
        float radius;
        double (*mass)(double);
    } filters[] = {{shared::CORE_FILTER_BOX, 0.5f, box_mass},
                   {shared::CORE_FILTER_GAUSSIAN, 1.5f, gaussian_mass},
                   {shared::CORE_FILTER_BLACKMAN_HARRIS, 2.0f, blackman_harris_mass}};
    for (const auto& filter : filters) {
        SCOPED_TRACE(filter.function);
        const auto points = run(filter.function, uniform_points(SAMPLES, 3), glm::vec4(filter.radius));
        std::vector<double> observed(CELLS * CELLS);
        for (const glm::vec4& p : points) {
            ASSERT_LE(std::max(std::abs(p.x), std::abs(p.y)), filter.radius * (1 + 1e-6f));
            const glm::dvec2 st =
                glm::clamp(glm::dvec2(p) / double(filter.radius) * 0.5 + 0.5, 0.0, 1 - 1e-12);
            ++observed[static_cast<std::size_t>(st.y * CELLS) * CELLS +
                       static_cast<std::size_t>(st.x * CELLS)];
        }
        std::vector<double> axis;
        for (std::size_t k = 0; k < CELLS; ++k) {
            const double left = 2.0 * static_cast<double>(k) / CELLS - 1;
            axis.push_back(filter.mass(left + 2.0 / CELLS) - filter.mass(left));
        }
        std::vector<double> expected;
        for (std::size_t k = 0; k < CELLS * CELLS; ++k)
            expected.push_back(axis[k % CELLS] * axis[k / CELLS] * SAMPLES);
        EXPECT_GT(chi_square(observed, expected).p, sidak_level(SIGNIFICANCE, 3));
    }
}

TEST_F(Warps, BlackmanHarrisInvertsItsIntegralToThreePartsIn100000) {
    std::vector<glm::vec4> items;
    for (int k = 0; k < 4096; ++k) items.emplace_back((static_cast<float>(k) + 0.5f) / 4096, 0.5f, 0, 0);
    const auto points = run(shared::CORE_FILTER_BLACKMAN_HARRIS, items, glm::vec4(1));
    for (std::size_t k = 0; k < items.size(); ++k)
        ASSERT_NEAR(blackman_harris_mass(points[k].x), items[k].x, 3e-5);
}

} // namespace
} // namespace ajar::test
