// Ways to solve the system, by name, and when to stop.
#pragma once

#include "radiosity/linear_system.hpp"
#include "radiosity/radiosity.hpp"

#include <functional>
#include <string_view>
#include <vector>

namespace ajar {

struct SolverRow {
    Choice choice;
    std::uint32_t blocks; // of rows that see each other's news (LinearSystem::gather); 0: shooting
};
const SolverRow& find_radiosity_solver(std::string_view name);

struct SolverLimits {
    double tolerance = 0; // of the greatest value
    std::uint32_t max_iterations = 0;
    double max_reflectance = 0; // of all rows and channels
};

struct SolverEnd {
    std::uint32_t iterations = 0;
    bool converged = false;
    bool stopped = false; // by keep_going
    bool stuck = false;   // the residual does not fall: light is not absorbed
};

// Solves from where the system begins. `record` is told of each iteration and says whether to go on, as
// keep_going does in between.
SolverEnd solve_system(LinearSystem& system, std::uint32_t rows, const SolverRow& solver,
                       const SolverLimits& limits,
                       const std::function<bool(const RadiosityIteration&)>& record,
                       const FormFactors::KeepGoing& keep_going);

// An upper estimate of what the iterations to come will still add to any value, given the greatest changes of
// those done: change q / (1 - q), where q, by which changes shrink, is at most the greatest reflectance and
// at most the greatest of the last three ratios seen.
double error_estimate(const std::vector<double>& changes, double max_reflectance);

} // namespace ajar
