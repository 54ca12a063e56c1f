#include "element_test.hpp"

#include "support/lambert.hpp"
#include "support/statistics.hpp"

#include <array>

namespace ajar::test {

namespace {

glm::dvec3 vertex(const Scene& scene, std::uint32_t instance, std::uint32_t triangle, int k) {
    const Mesh& mesh = scene.meshes[scene.instances[instance].mesh];
    return glm::dvec3(scene.instances[instance].to_world *
                      glm::vec4(mesh.positions[mesh.triangles[triangle][k]], 1));
}

} // namespace

glm::dvec3 place_of(const Scene& scene, const SceneElement& e, const glm::dvec2& at) {
    const glm::dvec3 a = vertex(scene, e.instance, e.triangle, 0);
    return a + at.x * (vertex(scene, e.instance, e.triangle, 1) - a) +
           at.y * (vertex(scene, e.instance, e.triangle, 2) - a);
}

namespace {

// The mean of a field over an element, on a grid of its own: cells of a parallelogram, of a triangle both
// triangles in each.
glm::dvec3 mean_of(const Scene& scene, const SceneElement& e, const Field& field) {
    constexpr int GRID = 12;
    glm::dvec3 sum(0);
    int count = 0;
    const auto add = [&](double a, double b) {
        sum += field(
            place_of(scene, e, glm::dvec2(e.origin) + a * glm::dvec2(e.edge_a) + b * glm::dvec2(e.edge_b)));
        ++count;
    };
    for (int j = 0; j < GRID; ++j)
        for (int i = 0; i < GRID; ++i) {
            if ((e.flags & shared::ELEMENT_QUAD) != 0) {
                add((i + 0.5) / GRID, (j + 0.5) / GRID);
                continue;
            }
            if (i + j < GRID) add((i + 1.0 / 3) / GRID, (j + 1.0 / 3) / GRID);
            if (i + j < GRID - 1) add((i + 2.0 / 3) / GRID, (j + 2.0 / 3) / GRID);
        }
    return sum / static_cast<double>(count);
}

} // namespace

std::vector<SceneElement> pieces(const Scene& scene, std::uint32_t instance, int rows, std::uint32_t flags) {
    std::vector<SceneElement> elements;
    const float side = 1.0f / static_cast<float>(rows);
    const Mesh& mesh = scene.meshes[scene.instances[instance].mesh];
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
        for (int j = 0; j < rows; ++j)
            for (int i = 0; i < rows - j; ++i) {
                const bool quad = i < rows - j - 1;
                elements.push_back({instance, t, flags | (quad ? shared::ELEMENT_QUAD : 0u),
                                    glm::vec2(i, j) * side, glm::vec2(side, 0), glm::vec2(0, side)});
            }
    return elements;
}

RenderSettings element_settings() {
    RenderSettings settings;
    settings.samples = 128;
    settings.max_bounces = 0;
    return settings;
}

Scene under_a_square_light() {
    SceneBuilder builder;
    builder.square({0, 0, 0}, {0, 1, 0}, 1.2f, builder.material(lambert({0.8f, 0.5f, 0.2f})));
    builder.square({0, 1.5f, 0}, {0, -1, 0}, 1, builder.material(emitter({4, 2, 1})));
    return builder.build();
}

glm::dvec3 of_the_square_light(const glm::dvec3& at) {
    const std::vector<glm::dvec3> corners = {{-1, 1.5, -1}, {1, 1.5, -1}, {1, 1.5, 1}, {-1, 1.5, 1}};
    return glm::dvec3(4, 2, 1) * polygon_irradiance(corners, at, {0, 1, 0});
}

ElementRadiance Irradiance::irradiance(const Scene& scene, const std::vector<SceneElement>& elements,
                                       const RenderSettings& settings) {
    ElementRadiance result = Renderer(device(), scene, {}).irradiance(elements, settings);
    EXPECT_EQ(result.stats.samples, settings.samples);
    EXPECT_EQ(result.stats.invalid_samples, 0u);
    EXPECT_EQ(result.stats.exhausted_loops, 0u);
    EXPECT_EQ(result.irradiance.size(), elements.size());
    return result;
}

void Irradiance::expect_irradiance(const Scene& scene, const std::vector<SceneElement>& elements,
                                   const RenderSettings& settings, const Field& field, double relative) {
    const ElementRadiance result = irradiance(scene, elements, settings);
    const double level = sidak_level(SIGNIFICANCE, 3 * elements.size());
    std::array<Moments, 3> residuals;
    double size = 0;
    for (std::size_t i = 0; i < elements.size(); ++i) {
        const glm::dvec3 right = mean_of(scene, elements[i], field);
        for (int c = 0; c < 3; ++c) {
            const double residual = result.irradiance[i][c] - right[c];
            residuals[static_cast<std::size_t>(c)].add(residual);
            size = std::max(size, right[c]);
            const double distance = std::max(std::abs(residual) - 0x1p-25 - relative * right[c], 0.0);
            const double p =
                distance == 0 ? 1 : normal_two_sided(distance / std::sqrt(result.variance[i][c]));
            EXPECT_GE(p, level) << "element " << i << ", channel " << c << ": " << result.irradiance[i][c]
                                << " +- " << std::sqrt(result.variance[i][c]) << ", not " << right[c];
        }
    }
    for (const Moments& m : residuals)
        EXPECT_GE(mean_p_value(m, 0, relative * size + 0x1p-25), SIGNIFICANCE / 3)
            << "mean residual " << m.mean() << " +- " << m.standard_error();
}

} // namespace ajar::test
