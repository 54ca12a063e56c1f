// How a solution came, as plots (image/plot.hpp).
#pragma once

#include "radiosity/settings.hpp"

#include <span>
#include <string>
#include <vector>

namespace ajar {

// What one solver did.
struct SolverHistory {
    std::string solver;
    std::vector<RadiosityIteration> iterations;
};

// An SVG document, over rows of form factors used. One solver: its residuals and the estimated error.
// Several, of one system: the share of the final power that each is still missing.
std::string convergence_plot(const std::string& title, std::span<const SolverHistory> histories);

} // namespace ajar
