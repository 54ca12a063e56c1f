#include "cli/lab/cases.hpp"

#include "cli/command.hpp"
#include "cli/render_options.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>

namespace ajar::cli {

namespace {

constexpr std::size_t MOST_CASES = 256;

bool always(const RenderSettings&) { return true; }

bool shows_patches(const RenderSettings& s) { return s.integrator == "radiosity"; }

bool has_strategy(const RenderSettings& s) {
    return s.integrator == "path" || s.integrator == "direct" || (shows_patches(s) && s.shading == "gather");
}

// Whether lights are looked for, rather than met by chance or not at all.
bool casts_shadow_rays(const RenderSettings& s) { return has_strategy(s) && s.strategy != "bsdf"; }

bool may_cast_several(const RenderSettings& s) { return casts_shadow_rays(s) && !shows_patches(s); }

bool combines(const RenderSettings& s) { return has_strategy(s) && s.strategy == "mis"; }

bool picks_a_light(const RenderSettings& s) {
    return casts_shadow_rays(s) && (s.light_rays == "one" || shows_patches(s));
}

constexpr std::array AXES{
    Axis{"--integrators", "--integrator", "What is computed", &RenderSettings::integrator, integrators,
         always},
    Axis{"--shadings", "--shading", "How integrator radiosity shows patches", &RenderSettings::shading,
         shadings, shows_patches},
    Axis{"--strategies", "--strategy", "How light is found", &RenderSettings::strategy, strategies,
         has_strategy},
    Axis{"--heuristics", "--heuristic", "How strategy mis weighs", &RenderSettings::heuristic, heuristics,
         combines},
    Axis{"--light-ray-choices", "--light-rays", "Shadow rays at a vertex", &RenderSettings::light_rays,
         light_ray_choices, may_cast_several},
    Axis{"--light-samplers", "--light-sampler", "How a light is picked", &RenderSettings::light_sampler,
         light_samplers, picks_a_light},
    Axis{"--env-samplings", "--env-sampling", "How a direction to an environment map is picked",
         &RenderSettings::environment_sampling, environment_samplings, combines},
    Axis{"--samplers", "--sampler", "Random numbers", &RenderSettings::sampler, samplers, always},
};

std::string trimmed(const std::string& text) {
    const std::size_t first = text.find_first_not_of(" \t");
    if (first == std::string::npos) return {};
    return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

} // namespace

std::span<const Axis> axes() { return AXES; }

std::vector<std::string> parse_names(const Axis& axis, const std::string& list) {
    std::vector<std::string> names;
    std::string known;
    for (const Choice& row : axis.choices()) known += (known.empty() ? "" : ", ") + std::string(row.name);
    for (const std::string& part : CLI::detail::split(list, ',')) {
        const std::string name = trimmed(part);
        const auto rows = axis.choices();
        const auto is_it = [&](const Choice& row) { return row.name == name; };
        if (name != "all" && std::none_of(rows.begin(), rows.end(), is_it))
            throw UsageError(fmt::format("{}: '{}' is none of {}, or all", axis.option, name, known));
        for (const Choice& row : rows)
            if ((name == "all" || row.name == name) &&
                std::find(names.begin(), names.end(), row.name) == names.end())
                names.emplace_back(row.name);
    }
    return names;
}

std::vector<Case> combinations(const RenderSettings& base,
                               const std::vector<std::vector<std::string>>& chosen) {
    std::vector<Case> cases{{"", base}};
    for (std::size_t a = 0; a < AXES.size(); ++a) {
        const Axis& axis = AXES[a];
        if (chosen[a].empty()) continue;
        std::vector<Case> next;
        for (const Case& c : cases) {
            if (!axis.matters(c.settings)) {
                next.push_back(c);
                continue;
            }
            for (const std::string& name : chosen[a]) {
                next.push_back(c);
                next.back().settings.*axis.setting = name;
                if (chosen[a].size() > 1) next.back().name += (c.name.empty() ? "" : ", ") + name;
            }
        }
        cases = std::move(next);
        if (cases.size() > MOST_CASES) throw UsageError(fmt::format("more than {} combinations", MOST_CASES));
    }
    for (Case& c : cases)
        if (c.name.empty()) c.name = c.settings.integrator;
    return cases;
}

RenderSettings parse_settings(const std::string& text, const RenderSettings& base, const std::string& where) {
    RenderOptions options;
    options.settings = base;
    CLI::App app;
    app.set_help_flag("");
    app.option_defaults()->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
    declare_image(app, options);
    declare_method(app, options);
    // The same for all, or what the lab itself is about.
    for (const char* fixed : {"--size", "--samples", "--first-sample", "--time-limit"})
        app.remove_option(app.get_option(fixed));
    try {
        app.parse(text);
    } catch (const CLI::ParseError& error) {
        throw UsageError(fmt::format("{}: {}", where, error.what()));
    }
    return options.settings;
}

Case parse_case(const std::string& text, const RenderSettings& base) {
    const std::size_t colon = text.find(':');
    const std::string name = trimmed(text.substr(0, colon));
    if (colon == std::string::npos || name.empty())
        throw UsageError(fmt::format("--case: '{}' is not \"NAME: --option value ...\"", text));
    return {name, parse_settings(text.substr(colon + 1), base, fmt::format("--case '{}'", name))};
}

} // namespace ajar::cli
