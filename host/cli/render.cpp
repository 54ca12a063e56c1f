// ajar render: checks the outputs, loads, renders, writes. What is decided here and nowhere else: what an
// interrupt saves, and the exit code.
#include "ajar/ajar.hpp"
#include "base/file.hpp"
#include "cli/command.hpp"
#include "cli/interrupts.hpp"
#include "cli/progress.hpp"
#include "cli/render_options.hpp"
#include "cli/rendering.hpp"

#include <fmt/format.h>

namespace ajar::cli {

namespace {

constexpr const char* EXAMPLES =
    "  ajar render scene.glb -o out.png\n"
    "  ajar render scene.glb -o out.exr -o out.png --size 1920x1080 --samples 256\n"
    "  ajar render scene.gltf -o out.exr --env studio.hdr --env-rotation 90 --aov\n"
    "  ajar render scene.glb -o out.png --tonemap agx --exposure 1 --time-limit 60\n"
    "  ajar render scene.glb -o out.exr --report out.json --progress json";

// Before hours of rendering: everything that can be known to fail at their end.
void check(const RenderOptions& o) {
    if (o.outputs.empty() && o.report.empty()) throw UsageError("nothing to write: -o FILE is missing");
    expect_possible(o.settings);
    for (const std::string& file : o.outputs) check_save(file, o.save);
    if (!o.report.empty()) const PendingFile writable(o.report);
}

void write(const RenderOptions& o, const RenderResult& result, ProgressDisplay& display) {
    for (const std::string& file : o.outputs) {
        save_image(file, result.image, o.save);
        display.written(file);
    }
    if (o.report.empty()) return;
    write_file(o.report, result.manifest);
    display.written(o.report);
}

std::string file_list(const RenderOptions& o) {
    std::string files;
    for (const std::string& file : o.outputs) files += (files.empty() ? "" : ", ") + file;
    if (!o.report.empty()) files += (files.empty() ? "" : ", ") + o.report;
    return files;
}

// Says what is not as asked for, and gives the exit code.
int conclude(const RenderOptions& o, const RenderResult& result, ProgressDisplay& display) {
    warn_of_losses(result, display);
    if (result.interrupted)
        display.notice(fmt::format("interrupted: {} of {} samples done, written to {}", result.samples,
                                   o.settings.samples, file_list(o)));
    else if (result.out_of_time)
        display.notice(fmt::format("time limit: {} of {} samples done", result.samples, o.settings.samples));
    display.finished(file_list(o), result.samples, result.render_seconds, result.rays, result.interrupted);
    return result.interrupted ? EXIT_INTERRUPTED : EXIT_OK;
}

int run(RenderOptions& o) {
    check(o);
    Interrupts interrupts;
    ProgressDisplay display(progress_mode(o.progress), o.settings.time_limit);
    const auto warn = [&](std::string_view line) { display.warning(line); };
    o.device.timestamps = !o.report.empty(); // nobody else looks at them
    const Device device = open_device(o, display);
    const SceneFile scene = load_scene(o, display);
    display.stage("prepare");
    Session session(scene, device, warn);
    display.stage("render");
    interrupts.enter(Interrupts::Phase::rendering);
    const RenderResult result = session.render(o.settings, [&](const Progress& progress) {
        if (!interrupts.requested()) display.update(progress);
        return !interrupts.requested();
    });
    if (result.samples == 0) {
        display.notice("interrupted before the first sample was done: nothing was written");
        return EXIT_INTERRUPTED;
    }
    interrupts.enter(Interrupts::Phase::writing);
    write(o, result, display);
    return conclude(o, result, display);
}

} // namespace

Command render_command(CLI::App& parent) {
    CLI::App* app = parent.add_subcommand("render", "Renders a glTF scene to images");
    app->footer(EXAMPLES);
    const auto options = std::make_shared<RenderOptions>();
    declare(*app, *options);
    return {app, [options] { return run(*options); }};
}

} // namespace ajar::cli
