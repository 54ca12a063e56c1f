#include "radiosity/convergence_plot.hpp"

#include "image/plot.hpp"

#include <algorithm>

namespace ajar {

namespace {

PlotLine line(std::string name, std::span<const RadiosityIteration> iterations,
              double RadiosityIteration::*value) {
    PlotLine line{std::move(name), {}};
    for (const RadiosityIteration& i : iterations)
        line.points.push_back({static_cast<double>(i.rows), i.*value});
    return line;
}

// All solvers come to one solution, from below: whoever came nearest stands for it.
RadiosityIteration nearest(std::span<const SolverHistory> histories) {
    RadiosityIteration best;
    for (const SolverHistory& h : histories)
        for (const RadiosityIteration& i : h.iterations)
            if (i.power > best.power) best = i;
    return best;
}

} // namespace

std::string convergence_plot(const std::string& title, std::span<const SolverHistory> histories) {
    LogPlot plot;
    plot.title = title;
    plot.x_label = "rows of form factors used";
    if (histories.size() == 1) {
        const std::vector<RadiosityIteration>& iterations = histories[0].iterations;
        plot.y_label = "share of the greatest value";
        plot.lines = {line("greatest change", iterations, &RadiosityIteration::residual),
                      line("change of power", iterations, &RadiosityIteration::residual_power),
                      line("estimated error", iterations, &RadiosityIteration::error)};
        return log_log_svg(plot);
    }
    plot.y_label = "share of the power still missing";
    const RadiosityIteration best = nearest(histories);
    for (const SolverHistory& h : histories) {
        PlotLine missing{h.solver, {}};
        for (const RadiosityIteration& i : h.iterations) {
            const double share = best.power > 0 ? 1 - i.power / best.power : 0;
            // What the best itself may still miss cannot be told from nothing.
            if (share > best.residual_power) missing.points.push_back({static_cast<double>(i.rows), share});
        }
        plot.lines.push_back(std::move(missing));
    }
    return log_log_svg(plot);
}

} // namespace ajar
