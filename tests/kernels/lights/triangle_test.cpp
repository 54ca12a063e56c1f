// Emissive triangles: densities and closed forms.
#include "light_functions.hpp"
#include "support/statistics.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace ajar::test {
namespace {

using namespace shared;
constexpr double PI = std::numbers::pi;

struct Case {
    const char* name;
    EmissiveTriangle light;
    glm::vec3 point;       // a receiver whose normal is +Y
    bool touching = false; // so near that sampling by area has next to no mean
};

std::vector<Case> all_cases() {
    // Fronts face down, towards the receiver.
    const EmissiveTriangle ceiling = triangle({-0.5f, 1, -0.3f}, {0.6f, 1, -0.2f}, {0.1f, 1, 0.7f});
    std::vector<Case> all{{"middling", ceiling, {0, 0, 0}},
                          {"near", ceiling, {0.05f, 0.95f, 0.1f}},
                          {"far", ceiling, {30, -80, 20}},
                          {"grazing", ceiling, {3, 0.97f, 0.5f}},
                          {"within its reach", ceiling, {0.1f, 0.999f, 0.1f}, true},
                          {"sliver", triangle({-4, 2, 0}, {4, 2, 0}, {0, 2.5f, 0.01f}), {1, 0, 2}},
                          {"away from the origin",
                           triangle({100, 51, -20}, {101, 51, -20}, {100, 51, -19}),
                           {100.3f, 50, -19.5f}}};
    return all;
}

// Van Oosterom and Strackee 1983.
double solid_angle(const EmissiveTriangle& t, glm::dvec3 point) {
    const glm::dvec3 a = glm::normalize(glm::dvec3(t.p0) - point);
    const glm::dvec3 b = glm::normalize(glm::dvec3(t.p1) - point);
    const glm::dvec3 c = glm::normalize(glm::dvec3(t.p2) - point);
    return 2 * std::atan2(std::abs(glm::dot(a, glm::cross(b, c))),
                          1 + glm::dot(a, b) + glm::dot(b, c) + glm::dot(c, a));
}

// Irradiance from a triangle of radiance 1 that lies wholly above the receiver's plane (Lambert 1760): half
// the sum over edges of the angle they span times the cosine between the edge's plane and the receiver.
double lambert_irradiance(const EmissiveTriangle& t, glm::dvec3 point, glm::dvec3 normal) {
    const std::array<glm::dvec3, 3> v{glm::normalize(glm::dvec3(t.p0) - point),
                                      glm::normalize(glm::dvec3(t.p1) - point),
                                      glm::normalize(glm::dvec3(t.p2) - point)};
    double sum = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const glm::dvec3 across = glm::cross(v[k], v[(k + 1) % 3]);
        const double length = glm::length(across);
        sum += std::atan2(length, glm::dot(v[k], v[(k + 1) % 3])) * glm::dot(across / length, normal);
    }
    return 0.5 * std::abs(sum);
}

struct Hit {
    bool there = false;
    double distance = 0;
    double cosine = 0;
};

Hit intersect(const EmissiveTriangle& t, glm::dvec3 point, glm::dvec3 direction) {
    const glm::dvec3 e1 = t.p1 - t.p0;
    const glm::dvec3 e2 = t.p2 - t.p0;
    const glm::dvec3 p = glm::cross(direction, e2);
    const double det = glm::dot(e1, p);
    const glm::dvec3 s = point - glm::dvec3(t.p0);
    const double u = glm::dot(s, p) / det;
    const glm::dvec3 q = glm::cross(s, e1);
    const double v = glm::dot(direction, q) / det;
    const double distance = glm::dot(e2, q) / det;
    return {u >= 0 && v >= 0 && u + v <= 1 && distance > 0, distance,
            std::abs(glm::dot(glm::normalize(glm::cross(e1, e2)), direction))};
}

// By area or by solid angle: the parameter is a feature bit, or none.
class TriangleLight : public LightFunctions, public testing::WithParamInterface<std::uint32_t> {
  protected:
    static bool by_solid_angle() { return GetParam() == FEATURE_WIDE_TRIANGLES; }

    static std::vector<Case> cases() {
        std::vector<Case> all = all_cases();
        if (!by_solid_angle()) std::erase_if(all, [](const Case& c) { return c.touching; });
        return all;
    }

    static Lighting lighting_of(const Case& c) {
        Lighting lighting;
        lighting.triangles.push_back(c.light);
        lighting.features = GetParam();
        return lighting;
    }

    static std::vector<LightItem> samples(const Case& c, std::size_t count = 200000) {
        return sample(lighting_of(c), 0, c.point, count, 11);
    }

    static double density(const EmissiveTriangle& t, glm::dvec3 point, glm::dvec3 direction) {
        const Hit hit = intersect(t, point, direction);
        if (!hit.there) return 0;
        if (by_solid_angle()) return 1 / solid_angle(t, point);
        const double area = 0.5 * glm::length(glm::cross(glm::dvec3(t.p1 - t.p0), glm::dvec3(t.p2 - t.p0)));
        return hit.distance * hit.distance / (area * hit.cosine);
    }
};
INSTANTIATE_TEST_SUITE_P(Sampled, TriangleLight, testing::Values(0u, FEATURE_WIDE_TRIANGLES),
                         [](const auto& row) { return row.param == 0 ? "ByArea" : "BySolidAngle"; });

TEST_P(TriangleLight, DirectionsFollowTheStatedDensity) {
    for (const Case& c : cases()) {
        if (c.touching) continue; // seen sideways: see below
        // Gnomonic projection about the triangle's middle, or its normal if that sees a corner sideways:
        // straight edges.
        const glm::dvec3 eye(c.point);
        const std::array<glm::dvec3, 3> corners{c.light.p0, c.light.p1, c.light.p2};
        glm::dvec3 axis = glm::normalize((corners[0] + corners[1] + corners[2]) / 3.0 - eye);
        if (std::any_of(corners.begin(), corners.end(),
                        [&](glm::dvec3 p) { return glm::dot(glm::normalize(p - eye), axis) < 0.3; }))
            axis = -glm::normalize(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
        const glm::dvec3 side = glm::normalize(
            glm::cross(axis, std::abs(axis.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 0, 1)));
        const glm::dvec3 up = glm::cross(side, axis);
        const auto project = [&](glm::dvec3 d) {
            return glm::dvec2(glm::dot(d, side), glm::dot(d, up)) / glm::dot(d, axis);
        };
        glm::dvec2 lower(1e30);
        glm::dvec2 upper(-1e30);
        for (const glm::dvec3& p : corners) {
            lower = glm::min(lower, project(p - eye));
            upper = glm::max(upper, project(p - eye));
        }
        const int bins = 16;
        const int steps = 48;
        std::vector<double> observed(bins * bins, 0);
        std::vector<double> expected(bins * bins, 0);
        const std::vector<LightItem> all = samples(c);
        for (const LightItem& item : all) {
            const glm::dvec2 at =
                (project(glm::dvec3(item.direction)) - lower) / (upper - lower) * double{bins};
            const glm::ivec2 bin = glm::clamp(glm::ivec2(glm::floor(at)), 0, bins - 1);
            observed[static_cast<std::size_t>(bin.y * bins + bin.x)] += 1;
        }
        const glm::dvec2 step = (upper - lower) / double{bins * steps};
        double total = 0;
        for (int y = 0; y < bins * steps; ++y)
            for (int x = 0; x < bins * steps; ++x) {
                const glm::dvec2 q = lower + (glm::dvec2(x, y) + 0.5) * step;
                const glm::dvec3 d = axis + q.x * side + q.y * up;
                const double length = glm::length(d);
                // d omega = dq / |d|^3
                const double mass =
                    density(c.light, eye, d / length) / (length * length * length) * step.x * step.y;
                expected[static_cast<std::size_t>(y / steps * bins + x / steps)] += mass;
                total += mass;
            }
        EXPECT_NEAR(total, 1, 0.02) << c.name;
        for (double& e : expected) e *= static_cast<double>(all.size()) / total;
        // Edges cut bins; samples on them may fall into one that the quadrature calls empty.
        for (double& e : expected) e = std::max(e, 1e-3);
        EXPECT_GT(chi_square(observed, expected).p, sidak_level(SIGNIFICANCE, cases().size())) << c.name;
    }
}

// Where a triangle covers much of the sphere: cells of it in latitude and longitude about its normal.
TEST_P(TriangleLight, DirectionsFillTheSolidAngleEvenlyFromCloseBy) {
    for (const Case& c : cases()) {
        const double omega = solid_angle(c.light, c.point);
        if (omega < 0.5) continue;
        const int rows = 24;
        const int columns = 32;
        const int steps = 40;
        std::vector<double> observed(rows * columns, 0);
        std::vector<double> expected(rows * columns, 0);
        const std::vector<LightItem> all = samples(c);
        for (const LightItem& item : all) {
            const double turn = std::atan2(item.direction.z, item.direction.x) / (2 * PI) + 0.5;
            const int row = std::clamp(static_cast<int>((item.direction.y + 1) / 2 * rows), 0, rows - 1);
            const int column = std::clamp(static_cast<int>(turn * columns), 0, columns - 1);
            observed[static_cast<std::size_t>(row * columns + column)] += 1;
        }
        double total = 0;
        for (int y = 0; y < rows * steps; ++y)
            for (int x = 0; x < columns * steps; ++x) {
                const double height = 2 * (y + 0.5) / (rows * steps) - 1;
                const double phi = ((x + 0.5) / (columns * steps) - 0.5) * 2 * PI;
                const double across = std::sqrt(1 - height * height);
                const glm::dvec3 d(across * std::cos(phi), height, across * std::sin(phi));
                const double mass = density(c.light, c.point, d) * 4 * PI / (rows * steps * columns * steps);
                expected[static_cast<std::size_t>(y / steps * columns + x / steps)] += mass;
                total += mass;
            }
        EXPECT_NEAR(total, 1, 0.01) << c.name;
        // Edges cut cells, and a sample may fall into a sliver of one that the quadrature misses.
        for (double& e : expected) e = std::max(e * static_cast<double>(all.size()) / total, 1e-3);
        EXPECT_GT(chi_square(observed, expected).p, sidak_level(SIGNIFICANCE, cases().size())) << c.name;
    }
}

TEST_P(TriangleLight, StatesItsDensity) {
    for (const Case& c : cases())
        for (const LightItem& item : samples(c, 1000)) {
            // From the sampled place itself: at grazing angles a float direction is too coarse to find it
            // again.
            const glm::dvec3 d = glm::dvec3(item.direction) * double{item.distance};
            const glm::dvec3 area_vector = 0.5 * glm::cross(glm::dvec3(c.light.p1) - glm::dvec3(c.light.p0),
                                                            glm::dvec3(c.light.p2) - glm::dvec3(c.light.p0));
            const double expected =
                by_solid_angle() ? 1 / solid_angle(c.light, c.point)
                                 : glm::dot(d, d) * glm::length(d) / std::abs(glm::dot(d, area_vector));
            ASSERT_NEAR(item.pdf, expected, (by_solid_angle() ? 5e-6 : 2e-4) * expected) << c.name;
            ASSERT_EQ(item.triangle, 17u);
            ASSERT_EQ(item.delta, 0u);
        }
}

TEST_P(TriangleLight, InverseDensityAveragesToTheSolidAngle) {
    for (const Case& c : cases()) {
        Moments moments;
        for (const LightItem& item : samples(c)) moments.add(1 / double{item.pdf});
        const double expected = solid_angle(c.light, c.point);
        EXPECT_GT(mean_p_value(moments, expected, 1e-5 * expected), sidak_level(SIGNIFICANCE, cases().size()))
            << c.name << ": " << moments.mean() << " for " << expected;
    }
}

TEST_P(TriangleLight, SamplesLieOnTheTriangle) {
    for (const Case& c : cases()) {
        const glm::dvec3 e1 = glm::dvec3(c.light.p1) - glm::dvec3(c.light.p0);
        const glm::dvec3 e2 = glm::dvec3(c.light.p2) - glm::dvec3(c.light.p0);
        const glm::dvec3 n = glm::cross(e1, e2) / glm::dot(glm::cross(e1, e2), glm::cross(e1, e2));
        for (const LightItem& item : samples(c, 10000)) {
            const glm::dvec3 p = glm::dvec3(c.point) + glm::dvec3(item.direction) * double{item.distance} -
                                 glm::dvec3(c.light.p0);
            // A unit of the direction's last place, as far away as it is, over the triangle's height.
            const double slack = 2e-7 * (item.distance + glm::length(glm::dvec3(c.point))) * glm::length(n) *
                                 std::max(glm::length(e1), glm::length(e2));
            const double b1 = glm::dot(glm::cross(p, e2), n);
            const double b2 = glm::dot(glm::cross(e1, p), n);
            ASSERT_GE(std::min({b1, b2, 1 - b1 - b2}), -slack) << c.name;
        }
    }
}

TEST_P(TriangleLight, IrradianceIsLamberts) {
    for (const Case& c : cases()) {
        Moments moments;
        for (const LightItem& item : samples(c))
            moments.add(double{item.radiance.x} * std::max(item.direction.y, 0.0f) / item.pdf);
        const double expected = lambert_irradiance(c.light, c.point, {0, 1, 0});
        EXPECT_GT(mean_p_value(moments, expected, 1e-5 * expected), sidak_level(SIGNIFICANCE, cases().size()))
            << c.name << ": " << moments.mean() << " for " << expected;
    }
}

TEST_P(TriangleLight, HitsHaveTheDensityOfSamples) {
    for (const Case& c : cases()) {
        std::vector<LightItem> items = samples(c, 10000);
        std::vector<float> sampled;
        for (LightItem& item : items) {
            sampled.push_back(item.pdf);
            item.triangle = 0;
        }
        const std::vector<LightItem> hits = run(LIGHTS_TRIANGLE_PDF, lighting_of(c), items);
        for (std::size_t i = 0; i < hits.size(); ++i)
            ASSERT_NEAR(hits[i].pdf, sampled[i], (by_solid_angle() ? 1e-6f : 2e-3f) * sampled[i]) << c.name;
    }
}

} // namespace
} // namespace ajar::test
