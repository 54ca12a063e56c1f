// Emissive triangles: densities, closed forms, sides and textures.
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

EmissiveTriangle triangle(glm::vec3 p0, glm::vec3 p1, glm::vec3 p2, float emission = 1) {
    EmissiveTriangle t;
    t.p0 = p0;
    t.p1 = p1;
    t.p2 = p2;
    t.area = 0.5f * glm::length(glm::cross(p1 - p0, p2 - p0));
    t.emission = glm::vec3(emission);
    t.triangle = 17;
    return t;
}

struct Case {
    const char* name;
    EmissiveTriangle light;
    glm::vec3 point; // a receiver whose normal is +Y
};

std::vector<Case> cases() {
    // Fronts face down, towards the receiver.
    const EmissiveTriangle ceiling = triangle({-0.5f, 1, -0.3f}, {0.6f, 1, -0.2f}, {0.1f, 1, 0.7f});
    std::vector<Case> all{{"middling", ceiling, {0, 0, 0}},
                          {"near", ceiling, {0.05f, 0.95f, 0.1f}},
                          {"far", ceiling, {30, -80, 20}},
                          {"grazing", ceiling, {3, 0.97f, 0.5f}},
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

double density(const EmissiveTriangle& t, glm::dvec3 point, glm::dvec3 direction) {
    const Hit hit = intersect(t, point, direction);
    const double area = 0.5 * glm::length(glm::cross(glm::dvec3(t.p1 - t.p0), glm::dvec3(t.p2 - t.p0)));
    return hit.there ? hit.distance * hit.distance / (area * hit.cosine) : 0;
}

class TriangleLight : public LightFunctions {
  protected:
    static std::vector<LightItem> samples(const Case& c, std::size_t count = 200000) {
        Lighting lighting;
        lighting.triangles.push_back(c.light);
        return sample(lighting, 0, c.point, count, 11);
    }
};

TEST_F(TriangleLight, DirectionsFollowTheStatedDensity) {
    for (const Case& c : cases()) {
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

TEST_F(TriangleLight, StatesTheDensityByAreaOverSolidAngle) {
    for (const Case& c : cases())
        for (const LightItem& item : samples(c, 1000)) {
            // From the sampled place itself: at grazing angles a float direction is too coarse to find it
            // again.
            const glm::dvec3 d = glm::dvec3(item.direction) * double{item.distance};
            const glm::dvec3 area_vector = 0.5 * glm::cross(glm::dvec3(c.light.p1) - glm::dvec3(c.light.p0),
                                                            glm::dvec3(c.light.p2) - glm::dvec3(c.light.p0));
            const double expected = glm::dot(d, d) * glm::length(d) / std::abs(glm::dot(d, area_vector));
            ASSERT_NEAR(item.pdf, expected, 2e-4 * expected) << c.name;
            ASSERT_EQ(item.triangle, 17u);
            ASSERT_EQ(item.delta, 0u);
        }
}

TEST_F(TriangleLight, InverseDensityAveragesToTheSolidAngle) {
    for (const Case& c : cases()) {
        Moments moments;
        for (const LightItem& item : samples(c)) moments.add(1 / double{item.pdf});
        const double expected = solid_angle(c.light, c.point);
        EXPECT_GT(mean_p_value(moments, expected, 1e-5 * expected), sidak_level(SIGNIFICANCE, cases().size()))
            << c.name << ": " << moments.mean() << " for " << expected;
    }
}

TEST_F(TriangleLight, IrradianceIsLamberts) {
    for (const Case& c : cases()) {
        Moments moments;
        for (const LightItem& item : samples(c))
            moments.add(double{item.radiance.x} * std::max(item.direction.y, 0.0f) / item.pdf);
        const double expected = lambert_irradiance(c.light, c.point, {0, 1, 0});
        EXPECT_GT(mean_p_value(moments, expected, 1e-5 * expected), sidak_level(SIGNIFICANCE, cases().size()))
            << c.name << ": " << moments.mean() << " for " << expected;
    }
}

TEST_F(TriangleLight, HitsHaveTheDensityOfSamples) {
    for (const Case& c : cases()) {
        std::vector<LightItem> items = samples(c, 10000);
        std::vector<float> sampled;
        for (LightItem& item : items) {
            sampled.push_back(item.pdf);
            item.point = glm::normalize(glm::cross(c.light.p1 - c.light.p0, c.light.p2 - c.light.p0));
            item.uv.x = c.light.area;
        }
        Lighting lighting;
        lighting.triangles.push_back(c.light);
        const std::vector<LightItem> hits = run(LIGHTS_TRIANGLE_PDF, lighting, items);
        for (std::size_t i = 0; i < hits.size(); ++i)
            ASSERT_NEAR(hits[i].pdf, sampled[i], 1e-3f * sampled[i]) << c.name;
    }
}

TEST_F(TriangleLight, EmitsFromItsFrontAloneUnlessTwoSided) {
    Lighting lighting;
    lighting.triangles = {triangle({-1, 1, -1}, {1, 1, -1}, {0, 1, 1}, 5),
                          triangle({-1, 1, -1}, {1, 1, -1}, {0, 1, 1}, 5)};
    lighting.triangles[1].two_sided = true;
    for (const std::uint32_t light : {0u, 1u})
        for (const float height : {0.0f, 2.0f}) // in front, behind
            for (const LightItem& item : sample(lighting, light, {0.1f, height, 0}, 100, 3))
                EXPECT_EQ(item.radiance.y, height < 1 || light == 1 ? 5.0f : 0.0f);
}

// The texture's left half emits, in the triangle's own texture coordinates: u = x.
Lighting textured(AlphaMode alpha_mode) {
    Lighting lighting;
    lighting.triangles = {triangle({0, 1, 0}, {1, 1, 0}, {0, 1, 1}),
                          triangle({0, 3, 0}, {1, 3, 0}, {0, 3, 1}, 7)};
    lighting.triangles[0].textured = true;
    lighting.triangles[0].triangle = 1;
    lighting.triangles[1].triangle = 0xfffffff0u; // must not be looked up
    lighting.surfaces.resize(2);
    lighting.surfaces[1].uv0[1] = glm::vec2(1, 0);
    lighting.surfaces[1].uv0[2] = glm::vec2(0, 1);
    TextureImage image;
    image.width = 2;
    image.height = 1;
    image.rgba = {255, 255, 255, 255, 0, 0, 0, 0};
    lighting.scene.images.push_back(image);
    Texture texture;
    texture.wrap_u = texture.wrap_v = Wrap::clamp;
    texture.filter = TextureFilter::nearest;
    lighting.scene.textures.push_back(texture);
    Material material;
    material.emission = glm::vec3(3, 2, 1);
    material.alpha_mode = alpha_mode;
    (alpha_mode == AlphaMode::opaque ? material.emission_texture : material.base_color_texture).texture = 0;
    lighting.scene.materials.push_back(material);
    if (alpha_mode != AlphaMode::opaque) lighting.features = FEATURE_ALPHA;
    return lighting;
}

TEST_F(TriangleLight, LooksTexturesAndAlphaUpAtTheSampledPoint) {
    for (const AlphaMode mode : {AlphaMode::opaque, AlphaMode::mask, AlphaMode::blend}) {
        const glm::vec3 point(0.2f, 0, 0.1f);
        int lit = 0;
        for (const LightItem& item : sample(textured(mode), 0, point, 1000, 3)) {
            const float x = point.x + item.direction.x * item.distance;
            if (std::abs(x - 0.5f) < 1e-4f) continue;
            const glm::vec3 expected = x < 0.5f ? glm::vec3(3, 2, 1) : glm::vec3(0);
            for (int c = 0; c < 3; ++c) EXPECT_NEAR(item.radiance[c], expected[c], 1e-5) << x;
            lit += x < 0.5f ? 1 : 0;
        }
        EXPECT_NEAR(lit, 750, 100);
        for (const LightItem& item : sample(textured(mode), 1, point, 100, 3))
            EXPECT_EQ(item.radiance, glm::vec3(7));
    }
}

} // namespace
} // namespace ajar::test
