// The solvers of the system: one answer, and how each comes to it.
#include "radiosity/solvers.hpp"
#include "radiosity_test.hpp"

#include <algorithm>
#include <cmath>

namespace ajar::test {
namespace {

class Solvers : public RadiosityTest {
  protected:
    static double greatest(const RadiositySolution& solution) {
        double value = 0;
        for (const glm::vec3& l : solution.radiance)
            for (int c = 0; c < 3; ++c) value = std::max<double>(value, l[c]);
        return value;
    }
    static double difference(const RadiositySolution& a, const RadiositySolution& b) {
        double value = 0;
        for (std::size_t side = 0; side < a.radiance.size(); ++side)
            for (int c = 0; c < 3; ++c)
                value = std::max<double>(value, std::abs(a.radiance[side][c] - b.radiance[side][c]));
        return value;
    }
    // Rows used until all but `share` of the power was there.
    static std::uint64_t rows_until(const RadiositySolution& solution, double share) {
        const double all = solution.history.back().power;
        for (const RadiosityIteration& it : solution.history)
            if (std::abs(it.power - all) <= share * all) return it.rows;
        return UINT64_MAX;
    }
};

TEST_F(Solvers, AgreeWithEachOther) {
    for (const Choice& direct : radiosity_directs()) {
        RadiositySettings settings = settings_of(500, 128);
        settings.direct = direct.name;
        settings.tolerance = 2e-5f;
        std::vector<RadiositySolution> solutions;
        for (const Choice& row : radiosity_solvers()) {
            settings.solver = row.name;
            solutions.push_back(solve(small_cornell_box(), settings));
        }
        for (const RadiositySolution& solution : solutions)
            EXPECT_LE(difference(solution, solutions[0]), 1e-4 * greatest(solutions[0]))
                << solution.stats.settings.solver << ", " << direct.name;
    }
}

TEST_F(Solvers, EstimateTheirErrorFromAbove) {
    RadiositySettings settings = settings_of(300, 64);
    settings.tolerance = 1e-6f;
    const RadiositySolution right = solve(small_cornell_box(), settings);
    for (const Choice& row : radiosity_solvers())
        for (const float tolerance : {1e-2f, 1e-3f}) {
            settings.solver = row.name;
            settings.tolerance = tolerance;
            const RadiositySolution solution = solve(small_cornell_box(), settings);
            const double error = difference(solution, right) / greatest(right);
            EXPECT_LE(error, tolerance) << row.name;
            EXPECT_LE(error, solution.history.back().error + 1e-5) << row.name;
            EXPECT_LE(solution.history.back().error, tolerance) << row.name;
        }
}

TEST_F(Solvers, GaussSeidelTakesFewerIterationsThanJacobi) {
    RadiositySettings settings = settings_of(500, 128);
    settings.solver = "jacobi";
    const RadiositySolution jacobi = solve(small_cornell_box(), settings);
    settings.solver = "gauss-seidel";
    const RadiositySolution gauss_seidel = solve(small_cornell_box(), settings);
    EXPECT_LT(gauss_seidel.stats.iterations, jacobi.stats.iterations);
    EXPECT_EQ(jacobi.history.back().rows, std::uint64_t{jacobi.stats.iterations} * jacobi.stats.sides);
}

TEST_F(Solvers, ShootingReachesAHundredthInFewerRowsThanJacobi) {
    for (const Choice& direct : radiosity_directs()) {
        RadiositySettings settings = settings_of(1000, 128);
        settings.direct = direct.name;
        settings.solver = "jacobi";
        const RadiositySolution jacobi = solve(small_cornell_box(), settings);
        settings.solver = "shooting";
        const RadiositySolution shooting = solve(small_cornell_box(), settings);
        EXPECT_LT(rows_until(shooting, 0.01), rows_until(jacobi, 0.01)) << direct.name;
        // The first to shoot are the luminaires, a handful.
        if (std::string(direct.name) == "form-factors") {
            EXPECT_LT(shooting.history[1].rows, shooting.stats.sides / 20);
        }
    }
}

TEST_F(Solvers, RecordResidualsThatFall) {
    RadiositySettings settings = settings_of(300, 64);
    for (const Choice& row : radiosity_solvers()) {
        settings.solver = row.name;
        const RadiositySolution solution = solve(small_cornell_box(), settings);
        const std::vector<RadiosityIteration>& history = solution.history;
        ASSERT_EQ(history.size(), solution.stats.iterations + 1u);
        for (std::size_t i = 1; i < history.size(); ++i) {
            EXPECT_EQ(history[i].iteration, i);
            EXPECT_GT(history[i].rows, history[i - 1].rows);
            EXPECT_LT(history[i].residual_power, history[i - 1].residual_power) << row.name;
            EXPECT_GE(history[i].power, history[i - 1].power * (1 - 1e-6)) << row.name;
        }
    }
}

TEST_F(Solvers, SayWhenNothingConverges) {
    // White walls absorb nothing: every iteration adds the emission once more.
    for (const Choice& row : radiosity_solvers()) {
        RadiositySettings settings = settings_of(50, 16);
        settings.solver = row.name;
        settings.direct = "form-factors";
        std::vector<std::string> warnings;
        const RadiositySolution solution =
            solve_radiosity(device(), furnace_room({1, 1, 1}, {1, 1, 1}), settings, {},
                            [&](std::string_view line) { warnings.emplace_back(line); });
        EXPECT_FALSE(solution.stats.converged) << row.name;
        EXPECT_FALSE(solution.stats.interrupted);
        EXPECT_LT(solution.stats.iterations, settings.max_iterations) << "it could be known earlier";
        ASSERT_EQ(warnings.size(), 1u);
        EXPECT_NE(warnings[0].find("did not converge"), std::string::npos) << warnings[0];
    }
    RadiositySettings settings = settings_of(50, 16);
    settings.max_iterations = 2;
    const RadiositySolution few =
        solve_radiosity(device(), furnace_room({0.9f, 0.9f, 0.9f}, {1, 1, 1}), settings);
    EXPECT_FALSE(few.stats.converged);
    EXPECT_EQ(few.stats.iterations, 2u);
}

TEST(ErrorEstimate, IsTheRestOfAGeometricSeries) {
    EXPECT_EQ(error_estimate({}, 0.5), 0);
    EXPECT_EQ(error_estimate({1}, 0), 0);
    EXPECT_DOUBLE_EQ(error_estimate({1}, 0.5), 1);
    // Falling by 3 each time, though the reflectance allows a half.
    EXPECT_NEAR(error_estimate({27, 9, 3, 1}, 0.5), 0.5, 1e-12);
    EXPECT_NEAR(error_estimate({27, 26, 9, 3, 1}, 0.9), 0.5, 0.05);
    EXPECT_TRUE(std::isinf(error_estimate({1, 1}, 1)));
}

} // namespace
} // namespace ajar::test
