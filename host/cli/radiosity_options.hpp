// The options that decide a radiosity solution, for every command that solves.
#pragma once

#include "cli/render_options.hpp"

namespace ajar::cli {

inline constexpr const char* RADIOSITY_GROUP = "Radiosity (integrator radiosity)";

void declare_radiosity(CLI::App& app, RadiositySettings& settings);
void declare_plot(CLI::App& app, ConvergencePlot& plot);

// Throws UsageError where one of them is given and nothing is solved.
void refuse_radiosity_options(const CLI::App& app);

} // namespace ajar::cli
