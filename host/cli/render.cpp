// ajar render: checks the outputs, loads, renders, writes. What is decided here and nowhere else: what an
// interrupt saves, and the exit code.
#include "cli/render.hpp"

#include "ajar/ajar.hpp"
#include "base/file.hpp"
#include "cli/command.hpp"
#include "cli/interrupts.hpp"
#include "cli/progress.hpp"
#include "cli/radiosity_options.hpp"
#include "cli/rendering.hpp"
#include "cli/solving.hpp"

#include <fmt/format.h>

namespace ajar::cli {

namespace {

constexpr const char* EXAMPLES =
    "  ajar render scene.glb -o out.png\n"
    "  ajar render scene.glb -o out.exr -o out.png --size 1920x1080 --samples 256\n"
    "  ajar render scene.gltf -o out.exr --env studio.hdr --env-rotation 90 --aov\n"
    "  ajar render scene.glb -o out.png --tonemap agx --exposure 1 --time-limit 60\n"
    "  ajar render scene.glb -o out.png --integrator radiosity --shading gather\n"
    "  ajar render scene.glb -o out.exr --report out.json --progress json";

bool solves(const RenderOptions& o) { return o.settings.integrator == "radiosity"; }

// Before hours of rendering: everything that can be known to fail at their end.
void check(const CLI::App& app, const RenderOptions& o) {
    if (!solves(o)) refuse_radiosity_options(app);
    if (o.outputs.empty() && o.report.empty()) throw UsageError("nothing to write: -o FILE is missing");
    expect_possible(o.settings);
    for (const std::string& file : o.outputs) check_save(file, o.save);
    for (const std::string& file : {o.report, o.plot.file})
        if (!file.empty()) const PendingFile writable(file);
}

void write(const RenderOptions& o, const RenderResult& result, const Solving& solving,
           ProgressDisplay& display) {
    for (const std::string& file : o.outputs) {
        save_image(file, result.image, o.save);
        display.written(file);
    }
    for (const auto& [file, text] :
         {std::pair(o.report, result.manifest), std::pair(o.plot.file, solving.plot_svg)}) {
        if (file.empty()) continue;
        write_file(file, text);
        display.written(file);
    }
}

std::string file_list(const RenderOptions& o) {
    std::string files;
    const auto add = [&](const std::string& file) {
        if (!file.empty()) files += (files.empty() ? "" : ", ") + file;
    };
    for (const std::string& file : o.outputs) add(file);
    add(o.report);
    add(o.plot.file);
    return files;
}

// Says what is not as asked for, and gives the exit code.
int conclude(const RenderOptions& o, const RenderResult& result, const Solving& solving,
             ProgressDisplay& display) {
    warn_of_losses(result, display);
    const bool unsolved = solving.result.stats.interrupted;
    if (unsolved)
        display.notice(fmt::format("interrupted: the solution after {} iterations, written to {}",
                                   solving.result.stats.iterations, file_list(o)));
    else if (result.interrupted)
        display.notice(fmt::format("interrupted: {} of {} samples done, written to {}", result.samples,
                                   o.settings.samples, file_list(o)));
    else if (result.out_of_time)
        display.notice(fmt::format("time limit: {} of {} samples done", result.samples, o.settings.samples));
    const bool interrupted = result.interrupted || unsolved;
    display.finished(file_list(o), result.samples, result.render_seconds, result.rays, interrupted);
    return interrupted ? EXIT_INTERRUPTED : EXIT_OK;
}

} // namespace

int run_render(const CLI::App& app, RenderOptions& o) {
    check(app, o);
    Interrupts interrupts;
    ProgressDisplay display(progress_mode(o.progress), o.settings.time_limit);
    const auto warn = [&](std::string_view line) { display.warning(line); };
    o.device.timestamps = !o.report.empty(); // nobody else looks at them
    const Device device = open_device(o, display);
    const SceneFile scene = load_scene(o, display);
    display.stage("prepare");
    Session session(scene, device, warn);
    interrupts.enter(Interrupts::Phase::rendering);
    const ProgressSink until_interrupted = [&](const Progress& progress) {
        if (!interrupts.requested()) display.update(progress);
        return !interrupts.requested();
    };
    Solving solving;
    if (solves(o)) solving = solve(session, o, until_interrupted);
    const bool unsolved = solving.result.stats.interrupted;
    if (unsolved && solving.result.history.empty()) {
        display.notice("interrupted before anything was solved: nothing was written");
        return EXIT_INTERRUPTED;
    }
    display.stage("render");
    // Whoever interrupts a solver gets a picture of what it has.
    if (unsolved) o.settings.samples = 1;
    const RenderResult result = session.render(o.settings, unsolved ? ProgressSink() : until_interrupted);
    if (result.samples == 0) {
        display.notice("interrupted before the first sample was done: nothing was written");
        return EXIT_INTERRUPTED;
    }
    interrupts.enter(Interrupts::Phase::writing);
    write(o, result, solving, display);
    return conclude(o, result, solving, display);
}

Command render_command(CLI::App& parent) {
    CLI::App* app = parent.add_subcommand("render", "Renders a glTF scene to images");
    app->footer(EXAMPLES);
    const auto options = std::make_shared<RenderOptions>();
    declare(*app, *options);
    return {app, [app, options] { return run_render(*app, *options); }};
}

} // namespace ajar::cli
