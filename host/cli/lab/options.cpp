#include "cli/lab/options.hpp"

#include "cli/command.hpp"
#include "cli/radiosity_options.hpp"
#include "cli/rendering.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <set>

namespace ajar::cli {

namespace {

void declare_cases(CLI::App& app, LabOptions& o) {
    const std::string group = "Cases (every combination of the lists; comma lists, or all)";
    o.lists.resize(axes().size());
    for (std::size_t a = 0; a < axes().size(); ++a) {
        const Axis& axis = axes()[a];
        std::string names;
        for (const Choice& row : axis.choices()) names += (names.empty() ? "" : ", ") + std::string(row.name);
        app.add_option(axis.option, o.lists[a], fmt::format("{}: {}", axis.what, names))
            ->type_name("LIST")
            ->check(CLI::Validator(
                [](const std::string& list) { return list.empty() ? "the list is empty" : std::string(); },
                ""))
            ->group(group);
    }
    app.add_option("--case", o.cases,
                   "\"NAME: --option value ...\": a case with any option of `ajar render` under Image and "
                   "Method; may be repeated. Without lists, the cases are these alone")
        ->type_name("CASE")
        ->allow_extra_args(false)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
        ->group(group);
    app.add_option("--seconds", o.seconds,
                   "Equal time: each case is rendered for so long (default: equal samples, see --samples)")
        ->type_name("SECONDS")
        ->check(CLI::Range(1e-3, 1e7).description(""))
        ->group(group);
    app.add_flag("--dry-run", o.dry_run, "List the cases and stop")->group(group);
}

void declare_reference(CLI::App& app, LabOptions& o) {
    const std::string group = "Reference";
    auto* file = app.add_option("--reference", o.reference, "An image to compare with, by `ajar render`")
                     ->type_name("FILE.exr")
                     ->group(group);
    const auto rendered = [&](CLI::Option* option) { option->group(group)->excludes(file); };
    rendered(app.add_option("--reference-samples", o.reference_samples,
                            fmt::format("Of the one that is rendered otherwise (default: {0} times the "
                                        "cases' samples, or {0} times their seconds)",
                                        REFERENCE_FACTOR))
                 ->type_name("N")
                 ->check(CLI::Range(1u, UINT32_MAX).description("")));
    rendered(app.add_option("--reference-options", o.reference_options,
                            "How it is rendered, as in --case (default: as `ajar render` does)")
                 ->type_name("OPTIONS"));
    rendered(app.add_option("--cache", o.cache,
                            "Folder where it is kept and found again, by a hash of scene, settings and "
                            "shaders (default: the output's)")
                 ->type_name("FOLDER"));
}

void declare_output_folder(CLI::App& app, LabOptions& o) {
    const std::string group = "Output";
    app.add_option("-o,--output", o.folder,
                   "Gets table.md, table.csv, lab.json, contact-sheet.png, error-samples.svg and "
                   "error-seconds.svg (default lab)")
        ->type_name("FOLDER")
        ->group(group);
    app.add_option("--title", o.title, "Of sheet and plots (default: the scene's name)")
        ->type_name("TEXT")
        ->group(group);
    app.add_option("--insets", o.insets,
                   "What the sheet magnifies: none, or X,Y,WIDTH,HEIGHT in pixels, or in parts of the "
                   "picture where all are at most 1; may be repeated (default: two places where the cases "
                   "differ most)")
        ->type_name("X,Y,W,H")
        ->allow_extra_args(false)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
        ->group(group);
    app.add_option("--sheet-samples", o.sheet_samples,
                   "A column of the sheet for each, such as 4,16,64 (default: one picture a case)")
        ->type_name("LIST")
        ->group(group);
}

// An option of `ajar render` that is a list here: whoever gives it gets told.
void replace_by_list(CLI::App& app, const Axis& axis) {
    app.remove_option(app.get_option(axis.replaces));
    const auto refuse = [&axis](const std::string& name) {
        throw CLI::ValidationError(
            fmt::format("{}: a lab compares rows of a list (use {} {})", axis.replaces, axis.option, name));
    };
    app.add_option_function<std::string>(axis.replaces, refuse)->group("");
}

template <class T> T parse_number(const std::string& text, const std::string& where) {
    T value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size())
        throw UsageError(fmt::format("{}: '{}' is not a number", where, text));
    return value;
}

std::array<double, 4> parse_inset(const std::string& text, const RenderSettings& s) {
    const std::vector<std::string> parts = CLI::detail::split(text, ',');
    const auto bad = [&](const char* why) { return UsageError(fmt::format("--insets: '{}' {}", text, why)); };
    if (parts.size() != 4) throw bad("is not X,Y,WIDTH,HEIGHT");
    std::array<double, 4> r{};
    for (std::size_t i = 0; i < 4; ++i) r[i] = parse_number<double>(parts[i], "--insets");
    const bool pixels = std::any_of(r.begin(), r.end(), [](double v) { return v > 1; });
    if (pixels)
        for (std::size_t i = 0; i < 4; ++i) r[i] /= i % 2 == 0 ? s.width : s.height;
    for (const double v : r)
        if (!(v >= 0 && v <= 1)) throw bad("reaches beyond the picture");
    if (r[2] == 0 || r[3] == 0) throw bad("has no area");
    if (r[0] + r[2] > 1 + 1e-9 || r[1] + r[3] > 1 + 1e-9) throw bad("reaches beyond the picture");
    return r;
}

std::vector<std::uint32_t> parse_stops(const LabOptions& o) {
    std::vector<std::uint32_t> stops;
    if (o.sheet_samples.empty()) return stops;
    if (o.seconds > 0) throw UsageError("--sheet-samples: needs equal samples, not --seconds");
    for (const std::string& part : CLI::detail::split(o.sheet_samples, ','))
        stops.push_back(parse_number<std::uint32_t>(part, "--sheet-samples"));
    std::sort(stops.begin(), stops.end());
    stops.erase(std::unique(stops.begin(), stops.end()), stops.end());
    if (stops.front() == 0 || stops.back() > o.render.settings.samples)
        throw UsageError(
            fmt::format("--sheet-samples: each must be from 1 to --samples, {}", o.render.settings.samples));
    if (stops.size() > 8) throw UsageError("--sheet-samples: at most 8 columns");
    return stops;
}

std::vector<Case> make_cases(const LabOptions& o) {
    std::vector<std::vector<std::string>> chosen;
    bool any_list = false;
    for (std::size_t a = 0; a < axes().size(); ++a) {
        any_list = any_list || !o.lists[a].empty();
        chosen.push_back(o.lists[a].empty() ? std::vector<std::string>{}
                                            : parse_names(axes()[a], o.lists[a]));
    }
    std::vector<Case> cases;
    if (any_list || o.cases.empty()) cases = combinations(o.render.settings, chosen);
    for (const std::string& text : o.cases) cases.push_back(parse_case(text, o.render.settings));
    std::set<std::string> names;
    for (const Case& c : cases)
        if (!names.insert(c.name).second) throw UsageError(fmt::format("two cases are named '{}'", c.name));
    return cases;
}

} // namespace

void declare(CLI::App& app, LabOptions& o) {
    // Small enough that a ladder of cases takes minutes on a CPU.
    o.render.settings.width = 480, o.render.settings.height = 270;
    app.add_option("SCENE", o.render.scene, "A .gltf or .glb file")->required();
    declare_cases(app, o);
    declare_reference(app, o);
    declare_output_folder(app, o);
    declare_display(app, o.render);
    declare_image(app, o.render);
    declare_method(app, o.render);
    declare_radiosity(app, o.render.radiosity);
    for (const Axis& axis : axes()) replace_by_list(app, axis);
    declare_scene(app, o.render);
    declare_device(app, o.render);
    app.remove_option(app.get_option("--time-limit"));   // --seconds
    app.remove_option(app.get_option("--first-sample")); // the ranges that a case is rendered in
    app.get_option("--seconds")->excludes(app.get_option("--samples"));
}

LabPlan make_plan(const LabOptions& o) {
    LabPlan plan;
    plan.cases = make_cases(o);
    plan.stops = parse_stops(o);
    const std::uint32_t samples = o.render.settings.samples;
    if (o.seconds > 0) {
        plan.budget.seconds = o.seconds;
        plan.reference_budget.seconds = o.seconds * REFERENCE_FACTOR;
    } else {
        plan.budget.samples = samples;
        plan.reference_budget.samples = static_cast<std::uint32_t>(
            std::min<std::uint64_t>(std::uint64_t{samples} * REFERENCE_FACTOR, UINT32_MAX));
    }
    if (o.reference_samples > 0) plan.reference_budget = {o.reference_samples, 0};
    for (const Case& c : plan.cases) expect_possible(c.settings, c.name + ": ");
    plan.reference_settings = parse_settings(o.reference_options, o.render.settings, "--reference-options");
    expect_possible(plan.reference_settings, "--reference-options: ");
    plan.reference_settings.seed ^= 0x80000000u; // other random numbers than the cases have
    plan.automatic_insets = o.insets.empty();
    for (const std::string& text : o.insets)
        if (text != "none") plan.insets.push_back(parse_inset(text, o.render.settings));
    return plan;
}

} // namespace ajar::cli
