#include "cli/solving.hpp"

#include "radiosity/convergence_plot.hpp"

#include <filesystem>

namespace ajar::cli {

Solving solve(Session& session, const RenderOptions& o, const ProgressSink& progress) {
    Solving solving;
    RadiositySettings settings = o.radiosity;
    settings.render = o.settings;
    std::vector<SolverHistory> histories;
    const auto solve_by = [&](const std::string& solver) {
        settings.solver = solver;
        solving.result = session.solve(settings, progress);
        histories.push_back({solver, solving.result.history});
    };
    for (const std::string& solver : o.plot.solvers)
        if (solver != o.radiosity.solver && !solving.result.stats.interrupted) solve_by(solver);
    if (!solving.result.stats.interrupted) solve_by(o.radiosity.solver); // the last one is shown
    if (!o.plot.file.empty())
        solving.plot_svg = convergence_plot(std::filesystem::path(o.scene).stem().string(), histories);
    return solving;
}

} // namespace ajar::cli
