#include "radiosity_test.hpp"

#include <cmath>

namespace ajar::test {

RadiositySolution RadiosityTest::solve(const Scene& scene, const RadiositySettings& settings) {
    const WarningSink warn = [](std::string_view line) { ADD_FAILURE() << "unexpected warning: " << line; };
    RadiositySolution solution = solve_radiosity(device(), scene, settings, {}, warn);
    EXPECT_TRUE(solution.stats.converged);
    EXPECT_FALSE(solution.stats.interrupted);
    EXPECT_EQ(solution.stats.exhausted_loops, 0u);
    EXPECT_EQ(solution.stats.invalid_samples, 0u);
    return solution;
}

void RadiosityTest::expect_everywhere(const RadiositySolution& solution, const std::vector<glm::vec3>& values,
                                      const glm::dvec3& right, double relative) {
    std::size_t wrong = 0;
    std::size_t sides = 0;
    for (std::size_t side = 0; side < values.size(); ++side) {
        if (solution.active[side] == 0) continue;
        ++sides;
        for (int c = 0; c < 3; ++c)
            if (!(std::abs(values[side][c] - right[c]) <= relative * right[c]) && ++wrong <= 5)
                ADD_FAILURE() << "side " << side << ", channel " << c << ": " << values[side][c] << ", not "
                              << right[c];
    }
    EXPECT_GT(sides, 0u);
    EXPECT_EQ(wrong, 0u) << "of " << 3 * sides;
}

RadiositySettings settings_of(std::uint32_t patches, std::uint32_t rays) {
    RadiositySettings settings;
    settings.patches = {0, patches};
    settings.rays = rays;
    return settings;
}

Scene furnace_room(const glm::vec3& a, const glm::vec3& e) {
    SceneBuilder builder;
    builder.room({-1, -1, -1}, {1, 1, 1}, builder.material(glowing_lambert(a, e)));
    return builder.build();
}

Scene small_cornell_box() {
    SceneBuilder builder;
    const std::uint32_t white = builder.material(lambert({0.73f, 0.73f, 0.73f}));
    const std::uint32_t red = builder.material(lambert({0.63f, 0.06f, 0.05f}));
    const std::uint32_t green = builder.material(lambert({0.14f, 0.45f, 0.09f}));
    builder.quad({0, 0, 0}, {0, 0, 2}, {2, 0, 2}, {2, 0, 0}, white); // floor
    builder.quad({0, 2, 0}, {2, 2, 0}, {2, 2, 2}, {0, 2, 2}, white); // ceiling
    builder.quad({0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, white); // back
    builder.quad({0, 0, 0}, {0, 2, 0}, {0, 2, 2}, {0, 0, 2}, red);
    builder.quad({2, 0, 0}, {2, 0, 2}, {2, 2, 2}, {2, 2, 0}, green);
    builder.box({0.3f, 0, 0.4f}, {0.9f, 1.2f, 1.0f}, white);
    builder.box({1.1f, 0, 1.0f}, {1.7f, 0.6f, 1.6f}, white);
    builder.square({1, 1.99f, 1}, {0, -1, 0}, 0.25f, builder.material(emitter({15, 12, 8})));
    builder.perspective({1, 1, 5.5f}, {1, 1, 0}, 0.65f);
    return builder.build();
}

} // namespace ajar::test
