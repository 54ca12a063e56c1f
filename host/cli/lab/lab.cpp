// ajar lab: renders the ladder of methods on one scene, each case against one reference, and writes what it
// found into a folder.
#include "ajar/ajar.hpp"
#include "base/clock.hpp"
#include "base/file.hpp"
#include "cli/command.hpp"
#include "cli/interrupts.hpp"
#include "cli/lab/pictures.hpp"
#include "cli/rendering.hpp"
#include "cli/solving.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <memory>

namespace ajar::cli {

namespace {

namespace fs = std::filesystem;

constexpr const char* EXAMPLES = "  ajar lab scene.glb --integrators path,naive --samples 64 -o ladder\n"
                                 "  ajar lab scene.glb --strategies all --light-samplers all --seconds 10\n"
                                 "  ajar lab scene.glb --samples 64 --sheet-samples 4,16,64 --size 256x256\n"
                                 "  ajar lab scene.glb --case \"all light: --max-bounces 12\" \\\n"
                                 "      --case \"no indirect light: --max-bounces 0\"\n"
                                 "  ajar lab scene.glb --strategies all --reference truth.exr --dry-run";

constexpr double SIGNIFICANCE = 1e-4; // of all means' tests together

void make_folder(const fs::path& folder) {
    std::error_code code;
    fs::create_directories(folder, code);
    if (!fs::is_directory(folder)) throw Error(fmt::format("{}: cannot be made a folder", folder.string()));
    const PendingFile writable(folder / "lab.json");
}

std::string list_cases(const LabPlan& plan) {
    std::string text;
    for (const Case& c : plan.cases) {
        text += fmt::format("{} (", c.name);
        for (const Axis& axis : axes())
            text += fmt::format("{}{} {}", &axis == axes().data() ? "" : " ", axis.replaces,
                                c.settings.*axis.setting);
        text += ")\n";
    }
    const Budget& b = plan.budget;
    return text + (b.samples > 0 ? fmt::format("{} cases of {} samples\n", plan.cases.size(), b.samples)
                                 : fmt::format("{} cases of {:g} seconds\n", plan.cases.size(), b.seconds));
}

// The share of the whole lab that is done, in units of one case.
class Timeline {
  public:
    Timeline(ProgressDisplay& display, const Interrupts& interrupts, double reference, std::size_t cases)
        : display_(display), interrupts_(interrupts), total_(reference + static_cast<double>(cases)) {}

    // A step of `weight` begins.
    ShareSink step(std::string label, double weight) {
        before_ += weight_;
        weight_ = weight;
        return [this, label = std::move(label)](double share) {
            if (interrupts_.requested()) return false;
            display_.overall(label, (before_ + share * weight_) / total_, seconds_since(start_));
            return true;
        };
    }

  private:
    ProgressDisplay& display_;
    const Interrupts& interrupts_;
    double total_;
    double before_ = 0, weight_ = 0;
    Clock::time_point start_ = Clock::now();
};

void write_results(const LabOptions& o, const LabPlan& plan, const LabResults& results,
                   ProgressDisplay& display) {
    const fs::path folder = o.folder;
    const auto write = [&](const char* name, const auto& writer) {
        writer(folder / name);
        display.written((folder / name).string());
    };
    const auto write_text = [&](const char* name, const std::string& text) {
        write(name, [&](const fs::path& file) { write_file(file, text); });
    };
    write_text("table.md", as_markdown(results));
    write_text("table.csv", as_csv(results));
    write_text("lab.json", as_json(results));
    write_text("error-samples.svg", plot_over_samples(results));
    write_text("error-seconds.svg", plot_over_seconds(results));
    write("contact-sheet.png", [&](const fs::path& file) {
        save_image(file, lab_sheet(results, plan, o.render.save)); // tone-mapped already
    });
}

// A case is a step; what is finished when an interrupt comes is kept.
std::vector<Measured> measure_all(Session& session, const LabPlan& plan, const Reference& reference,
                                  Timeline& timeline, ProgressDisplay& display) {
    std::vector<Measured> measured;
    const double significance = sidak_level(SIGNIFICANCE, plan.cases.size());
    for (const Case& c : plan.cases) {
        const std::string label =
            fmt::format("case {} of {}: {}", measured.size() + 1, plan.cases.size(), c.name);
        std::optional<Measured> m = measure(session, c, plan, {reference.image, reference.noise},
                                            significance, timeline.step(label, 1));
        if (!m) break;
        warn_of_losses(m->totals, display, c.name + ": ");
        measured.push_back(std::move(*m));
    }
    return measured;
}

// One solution for all cases that show it, and for the reference. False when interrupted.
bool solve_for_cases(Session& session, const LabOptions& o, const LabPlan& plan, ProgressDisplay& display,
                     const Interrupts& interrupts) {
    const auto shows = [](const RenderSettings& s) { return s.integrator == "radiosity"; };
    const bool wanted =
        shows(plan.reference_settings) ||
        std::any_of(plan.cases.begin(), plan.cases.end(), [&](const Case& c) { return shows(c.settings); });
    if (!wanted) return true;
    const Solving solving = solve(session, o.render, [&](const Progress& progress) {
        if (!interrupts.requested()) display.update(progress);
        return !interrupts.requested();
    });
    return !solving.result.stats.interrupted;
}

int run(LabOptions& o) {
    LabPlan plan = make_plan(o);
    if (o.dry_run) {
        print_result(list_cases(plan));
        return EXIT_OK;
    }
    Interrupts interrupts; // before the reader of images starts threads
    make_folder(o.folder);
    if (!o.cache.empty()) make_folder(o.cache);
    Reference reference;
    if (!o.reference.empty()) reference = read_reference(o.reference, o.render.settings);
    ProgressDisplay display(progress_mode(o.render.progress), 0);
    o.render.device.timestamps = false;
    const Device device = open_device(o.render, display);
    const SceneFile scene = load_scene(o.render, display);
    plan = make_plan(o); // with the background that the scene has got
    display.stage("prepare");
    Session session(scene, device, [&](std::string_view line) { display.warning(line); });
    interrupts.enter(Interrupts::Phase::rendering);
    if (!solve_for_cases(session, o, plan, display, interrupts)) {
        display.notice("interrupted before anything was solved: no results were written");
        return EXIT_INTERRUPTED;
    }
    const double weight = reference.given ? 0
                          : plan.budget.samples > 0
                              ? static_cast<double>(plan.reference_budget.samples) / plan.budget.samples
                              : REFERENCE_FACTOR;
    Timeline timeline(display, interrupts, weight, plan.cases.size());
    if (!reference.given)
        reference = render_reference(session, plan, o.cache.empty() ? o.folder : o.cache, display,
                                     timeline.step("reference", weight));
    std::vector<Measured> cases;
    if (!reference.interrupted) cases = measure_all(session, plan, reference, timeline, display);
    if (cases.empty()) {
        display.notice("interrupted before the first case was done: no results were written");
        return EXIT_INTERRUPTED;
    }
    interrupts.enter(Interrupts::Phase::writing);
    const bool interrupted = cases.size() < plan.cases.size();
    const LabResults results{o.title.empty() ? fs::path(o.render.scene).stem().string() : o.title,
                             scene.name(),
                             plan.budget,
                             reference,
                             cases,
                             interrupted};
    write_results(o, plan, results, display);
    display.done(interrupted);
    if (o.render.progress != "json") print_result(as_markdown(results));
    if (const auto line = reference_warning(results)) display.warning(*line);
    if (interrupted)
        display.notice(fmt::format("interrupted: {} of {} cases done, written to {}", cases.size(),
                                   plan.cases.size(), o.folder));
    return interrupted ? EXIT_INTERRUPTED : EXIT_OK;
}

} // namespace

Command lab_command(CLI::App& parent) {
    CLI::App* app = parent.add_subcommand(
        "lab", "Renders a scene by many methods against a reference, and shows what each of them buys");
    app->footer(EXAMPLES);
    const auto options = std::make_shared<LabOptions>();
    declare(*app, *options);
    return {app, [options] { return run(*options); }};
}

} // namespace ajar::cli
