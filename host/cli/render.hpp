// What `ajar render` and `ajar radiosity` do once their options are parsed.
#pragma once

#include "cli/render_options.hpp"

namespace ajar::cli {

// Checks, loads, solves where integrator radiosity is asked for, renders and writes. Returns the exit code.
int run_render(const CLI::App& app, RenderOptions& options);

} // namespace ajar::cli
