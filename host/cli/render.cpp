// ajar render: checks the outputs, loads, lights, renders, writes. What is decided here and nowhere else: the
// default environment, what an interrupt saves, and the exit code.
#include "ajar/ajar.hpp"
#include "base/file.hpp"
#include "cli/command.hpp"
#include "cli/interrupts.hpp"
#include "cli/progress.hpp"
#include "cli/render_options.hpp"
#include "shaders/shared/film.glsl.h"

#include <cstdlib>
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
    for (const std::string& file : o.outputs) check_save(file, o.save);
    if (!o.report.empty()) const PendingFile writable(o.report);
}

SceneFile load(RenderOptions& o, ProgressDisplay& display) {
    display.stage("load");
    o.load.aspect = static_cast<float>(o.settings.width) / static_cast<float>(o.settings.height);
    o.load.warn = [&](std::string_view line) { display.warning(line); };
    SceneFile scene = SceneFile::load(o.scene, o.load);
    if (!o.environment.empty()) scene.set_environment(o.environment, o.environment_options);
    if (o.background) std::copy(o.background->begin(), o.background->end(), o.settings.background);
    if (!o.background && !scene.has_light()) {
        scene.set_default_environment();
        display.notice("the scene has no light: lit by a soft grey studio (see --env, --background)");
    }
    return scene;
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

std::string samples_text(std::uint64_t count) {
    return count == 1 ? "1 sample" : fmt::format("{} samples", count);
}

// A picture may look right and still lack something.
void warn_of_losses(const RenderResult& result, ProgressDisplay& display) {
    if (result.invalid_samples > 0)
        display.warning(fmt::format(
            "{} of NaN, infinite or negative radiance counted as black (the first: pixel {}, {}, sample {})",
            samples_text(result.invalid_samples), result.first_invalid[0], result.first_invalid[1],
            result.first_invalid[2]));
    if (result.saturated_samples > 0)
        display.warning(fmt::format("{} brighter than {:.0f} cut there, so the picture is too dark",
                                    samples_text(result.saturated_samples), shared::FILM_MAX_SAMPLE));
    if (result.exhausted_loops > 0)
        display.warning(
            fmt::format("{} rays were given up before all was searched that they might hit (a defect: please "
                        "report it with the scene)",
                        result.exhausted_loops));
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
    if (!o.no_cache)
        o.device.cache_folder = default_cache_folder(std::getenv("XDG_CACHE_HOME"), std::getenv("HOME"));
    o.device.on_validation = [&](std::string_view line) {
        display.warning(fmt::format("validation: {}", line));
    };
    o.device.timestamps = !o.report.empty(); // nobody else looks at them
    const Device device(o.device);
    const SceneFile scene = load(o, display);
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
