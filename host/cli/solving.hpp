// Solving for radiosity before a render shows it.
#pragma once

#include "ajar/ajar.hpp"
#include "cli/render_options.hpp"

namespace ajar::cli {

// Writes nothing; `plot_svg` is what --plot asks for.
struct Solving {
    RadiosityResult result;
    std::string plot_svg;
};

// `progress` says when to stop; what is known by then is the solution.
Solving solve(Session& session, const RenderOptions& options, const ProgressSink& progress);

} // namespace ajar::cli
