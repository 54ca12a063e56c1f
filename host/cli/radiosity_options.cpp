#include "cli/radiosity_options.hpp"

#include "cli/command.hpp"
#include "cli/help.hpp"
#include "cli/numbers.hpp"
#include "radiosity/radiosity.hpp"
#include "shaders/shared/patch.glsl.h"

#include <bit>
#include <cmath>
#include <fmt/format.h>

namespace ajar::cli {

namespace {

constexpr double GIB = 1073741824;

CLI::Validator power_of_two(std::uint32_t low, std::uint32_t high) {
    return CLI::Validator(
        [low, high](const std::string& text) {
            const std::string fault = count(low, high)(text);
            const auto value = static_cast<std::uint32_t>(std::strtoul(text.c_str(), nullptr, 10));
            if (fault.empty() && std::has_single_bit(value) && text == std::to_string(value))
                return std::string();
            return fmt::format("'{}' is not a power of two from {} to {}", text, low, high);
        },
        "");
}

void choose_solvers(ConvergencePlot& plot, const std::string& list) {
    std::string known;
    for (const Choice& row : radiosity_solvers())
        known += (known.empty() ? "" : ", ") + std::string(row.name);
    plot.solvers.clear();
    for (const std::string& name : CLI::detail::split(list, ',')) {
        const std::size_t before = plot.solvers.size();
        for (const Choice& row : radiosity_solvers())
            if (name == "all" || name == row.name) plot.solvers.emplace_back(row.name);
        if (plot.solvers.size() == before)
            throw CLI::ValidationError(
                fmt::format("--plot-solvers: '{}' is none of {}, or all", name, known));
    }
}

} // namespace

void declare_radiosity(CLI::App& app, RadiositySettings& s) {
    const std::string group = RADIOSITY_GROUP;
    auto* patches = app.add_option("--patches", s.patches.patches,
                                   fmt::format("At least so many (default {}, or as --patch-size has it)",
                                               s.patches.patches))
                        ->type_name("N")
                        ->check(count(1, shared::MAX_PATCHES))
                        ->group(group);
    app.add_option_function<float>(
           "--patch-size",
           [&s, patches](float size) {
               s.patches.patch_size = size;
               if (patches->count() == 0) s.patches.patches = 0;
           },
           "No patch has a longer edge")
        ->type_name("METRES")
        ->check(number(1e-6, HUGE_NUMBER))
        ->group(group);
    app.add_option("--refine", s.refine,
                   "Times that patches are halved where light changes quickly (default 0)")
        ->type_name("N")
        ->check(count(0, 32))
        ->group(group);
    app.add_option(
           "--solver", s.solver,
           help_from(fmt::format("How the system is solved (default {})", s.solver), radiosity_solvers()))
        ->type_name("NAME")
        ->check(one_of(radiosity_solvers()))
        ->group(group);
    app.add_option(
           "--direct", s.direct,
           help_from(fmt::format("How luminaires light patches (default {})", s.direct), radiosity_directs()))
        ->type_name("NAME")
        ->check(one_of(radiosity_directs()))
        ->group(group);
    app.add_option("--rays", s.rays,
                   fmt::format("For the form factors of a patch's side; a power of two (default {})", s.rays))
        ->type_name("N")
        ->check(power_of_two(4, 65536))
        ->group(group);
    app.add_option("--shadow-samples", s.shadow_samples,
                   fmt::format("To luminaires from a patch's side (default {})", s.shadow_samples))
        ->type_name("N")
        ->check(count(1, 1u << 20))
        ->group(group);
    app.add_option(
           "--tolerance", s.tolerance,
           fmt::format("Greatest error of the solution, of its greatest value (default {:g})", s.tolerance))
        ->type_name("X")
        ->check(number(1e-7, 1))
        ->group(group);
    app.add_option("--max-iterations", s.max_iterations,
                   fmt::format("Give up after so many (default {})", s.max_iterations))
        ->type_name("N")
        ->check(count(1))
        ->group(group);
    app.add_option_function<double>(
           "--memory",
           [&s](double gib) { s.memory_bytes = static_cast<std::uint64_t>(std::llround(gib * GIB)); },
           fmt::format("GiB of form factors that are kept; others are computed again in every iteration, "
                       "which changes nothing but the time (default {:g})",
                       static_cast<double>(s.memory_bytes) / GIB))
        ->type_name("GIB")
        ->check(number(0, 1e6))
        ->group(group);
}

void declare_plot(CLI::App& app, ConvergencePlot& plot) {
    const std::string group = RADIOSITY_GROUP;
    auto* file = app.add_option("--plot", plot.file, "SVG: how the solution converged")
                     ->type_name("FILE.svg")
                     ->group(group);
    app.add_option_function<std::string>(
           "--plot-solvers", [&plot](const std::string& list) { choose_solvers(plot, list); },
           "Solve by these too, comma list or all, and plot them together")
        ->type_name("LIST")
        ->needs(file)
        ->group(group);
}

void refuse_radiosity_options(const CLI::App& app) {
    for (const CLI::Option* option : app.get_options())
        if (option->count() > 0 && (option->get_group() == RADIOSITY_GROUP || option->check_lname("shading")))
            throw UsageError(fmt::format("{}: only integrator radiosity looks at it", option->get_name()));
}

} // namespace ajar::cli
