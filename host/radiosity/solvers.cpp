#include "radiosity/solvers.hpp"

#include "base/error.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <iterator>
#include <limits>

namespace ajar {

namespace {

constexpr SolverRow SOLVERS[] = {
    {{"gauss-seidel", "each of 64 blocks of patches sees what those before it found"}, 64},
    {{"jacobi", "all patches gather at once, a bounce an iteration"}, 1},
    {{"shooting", "the brightest patches send out what they have: progressive refinement"}, 0},
};

constexpr auto CHOICES = [] {
    std::array<Choice, std::size(SOLVERS)> choices{};
    for (std::size_t i = 0; i < choices.size(); ++i) choices[i] = SOLVERS[i].choice;
    return choices;
}();

// Iterations in which the rest must fall by a hundredth; shooting takes smaller steps.
constexpr std::size_t GATHER_PATIENCE = 16;
constexpr std::size_t SHOOT_PATIENCE = 64;

bool is_stuck(const std::vector<double>& rests, std::size_t patience) {
    return rests.size() > 2 * patience && rests.back() > 0.99 * rests[rests.size() - 1 - patience];
}

RadiosityIteration iteration_of(const SystemMeasure& m, std::uint32_t iteration, std::uint64_t rows) {
    RadiosityIteration it;
    it.iteration = iteration;
    it.rows = rows;
    it.residual = m.max_value > 0 ? m.max_rest / m.max_value : 0;
    it.residual_power = m.power > 0 ? m.rest_power / m.power : 0;
    it.power = m.power;
    return it;
}

} // namespace

std::span<const Choice> radiosity_solvers() { return CHOICES; }

const SolverRow& find_radiosity_solver(std::string_view name) {
    std::string known;
    for (const SolverRow& row : SOLVERS) {
        if (row.choice.name == name) return row;
        known += known.empty() ? row.choice.name : std::string(", ") + row.choice.name;
    }
    throw Error(fmt::format("solver '{}': there is none of that name (there are: {})", name, known));
}

double error_estimate(const std::vector<double>& changes, double max_reflectance) {
    if (changes.empty() || changes.back() == 0) return 0;
    double q = max_reflectance;
    constexpr std::size_t RATIOS = 3;
    if (changes.size() > RATIOS) {
        double seen = 0;
        for (std::size_t k = changes.size() - RATIOS; k < changes.size(); ++k)
            seen = std::max(seen, changes[k] / changes[k - 1]);
        q = std::min(q, seen);
    }
    return q < 1 ? changes.back() * q / (1 - q) : std::numeric_limits<double>::infinity();
}

SolverEnd solve_system(LinearSystem& system, std::uint32_t rows, const SolverRow& solver,
                       const SolverLimits& limits,
                       const std::function<bool(const RadiosityIteration&)>& record,
                       const FormFactors::KeepGoing& keep_going) {
    const bool shoots = solver.blocks == 0;
    // What has not been shot can come back to one place by many ways, so no ratio is seen: the greatest
    // reflectance bounds it, where it is not 1 itself.
    const double shooting_q = std::min(limits.max_reflectance, 0.999);
    std::vector<double> changes;
    std::vector<double> powers;
    std::uint64_t rows_used = 0;
    SolverEnd end;
    SystemMeasure measure = system.measure();
    for (;; ++end.iterations) {
        changes.push_back(measure.max_rest);
        powers.push_back(measure.rest_power);
        RadiosityIteration it = iteration_of(measure, end.iterations, rows_used);
        const double error = shoots ? measure.max_rest * shooting_q / (1 - shooting_q)
                                    : error_estimate(changes, limits.max_reflectance);
        it.error = measure.max_value > 0 ? error / measure.max_value : 0;
        end.converged = it.error <= limits.tolerance;
        end.stopped = !record(it);
        end.stuck = is_stuck(powers, shoots ? SHOOT_PATIENCE : GATHER_PATIENCE);
        if (end.converged || end.stopped || end.stuck || end.iterations >= limits.max_iterations) return end;
        if (shoots) {
            const std::uint32_t shooters = system.shoot(measure.max_rest_power, keep_going);
            rows_used += shooters;
            end.stopped = shooters == 0;
        } else {
            end.stopped = !system.gather(solver.blocks, keep_going);
            rows_used += rows;
        }
        if (end.stopped) return end;
        measure = system.measure();
    }
}

} // namespace ajar
