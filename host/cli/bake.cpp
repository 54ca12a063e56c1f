// ajar bake: checks the outputs, loads, bakes, writes.
#include "bake/bake.hpp"
#include "ajar/ajar.hpp"
#include "base/file.hpp"
#include "cli/command.hpp"
#include "cli/help.hpp"
#include "cli/interrupts.hpp"
#include "cli/numbers.hpp"
#include "cli/progress.hpp"
#include "cli/render_options.hpp"
#include "cli/rendering.hpp"

#include <fmt/format.h>

namespace ajar::cli {

namespace {

constexpr const char* EXAMPLES = "  ajar bake scene.glb -o baked.glb\n"
                                 "  ajar bake scene.glb -o baked.glb --patches 100000 --exposure -1\n"
                                 "  ajar bake scene.glb -o baked.glb --lightmap 2048 --samples 1024\n"
                                 "  ajar bake scene.glb -o baked.glb --occlusion 1024 --ao-distance 0.5\n"
                                 "  ajar bake scene.glb -o baked.glb --lightmap 1024 --env studio.hdr";

constexpr std::uint32_t SMALLEST_SIDE = 16, LARGEST_SIDE = 8192; // texels

struct Options {
    RenderOptions common; // of its groups those for scenes, devices, samples
    BakeSettings bake;
    std::string output;
};

void check(const Options& o) {
    if (o.output.empty()) throw UsageError("nothing to write: -o FILE.glb is missing");
    check_bake_files(o.output, o.bake);
    if (!o.common.report.empty()) const PendingFile writable(o.common.report);
}

// Writes everything and returns what to call it.
std::string write(const Options& o, const BakeResult& result, ProgressDisplay& display) {
    std::string files;
    const auto wrote = [&](const std::string& file) {
        display.written(file);
        files += (files.empty() ? "" : ", ") + file;
    };
    save_bake(o.output, result);
    for (const std::filesystem::path& file : bake_files(o.output, o.bake)) wrote(file.string());
    if (o.common.report.empty()) return files;
    write_file(o.common.report, result.manifest);
    wrote(o.common.report);
    return files;
}

void warn_of_losses(const BakeResult& result, ProgressDisplay& display) {
    if (result.invalid_samples > 0)
        display.warning(fmt::format("{} samples of NaN, infinite or negative radiance counted as black",
                                    result.invalid_samples));
    if (result.saturated_samples > 0)
        display.warning(fmt::format("{} samples were too bright and cut, so what is baked is too dark",
                                    result.saturated_samples));
    if (result.exhausted_loops > 0)
        display.warning(fmt::format("{} rays were given up before all was searched that they might hit (a "
                                    "defect: please report it with the scene)",
                                    result.exhausted_loops));
}

int run(Options& o) {
    check(o);
    Interrupts interrupts;
    ProgressDisplay display(progress_mode(o.common.progress), o.common.settings.time_limit);
    o.common.device.timestamps = !o.common.report.empty(); // nobody else looks at them
    const Device device = open_device(o.common, display);
    const SceneFile scene = read_scene(o.common, display);
    display.stage("prepare");
    o.bake.render = o.common.settings;
    bool computes = false;
    const auto progress = [&](const Progress& p) {
        if (!computes) display.stage("bake"), interrupts.enter(Interrupts::Phase::rendering);
        computes = true;
        if (!interrupts.requested()) display.update(p);
        return !interrupts.requested();
    };
    const auto warn = [&](std::string_view line) { display.warning(line); };
    const BakeResult result = bake(scene, device, o.bake, progress, warn);
    if (result.samples == 0) {
        display.notice("interrupted before the first sample was done: nothing was written");
        return EXIT_INTERRUPTED;
    }
    interrupts.enter(Interrupts::Phase::writing);
    const std::string files = write(o, result, display);
    warn_of_losses(result, display);
    if (result.interrupted)
        display.notice(fmt::format("interrupted: {} of {} samples done, written to {}", result.samples,
                                   o.bake.render.samples, files));
    else if (result.out_of_time)
        display.notice(
            fmt::format("time limit: {} of {} samples done", result.samples, o.bake.render.samples));
    display.finished(files, result.samples, result.seconds, result.rays, result.interrupted);
    return result.interrupted ? EXIT_INTERRUPTED : EXIT_OK;
}

void declare_target(CLI::App& app, Options& o) {
    const std::string group = "What is baked (one of the first three)";
    BakeSettings& b = o.bake;
    CLI::Option* vertices =
        app.add_flag_callback(
               "--vertices", [&b] { b.to = "vertices"; },
               "Vertex colours (COLOR_0) of a finer mesh, unlit, times the textures it had (the default)")
            ->group(group);
    const auto atlas = [&](const char* name, const char* to, const char* help) {
        return app
            .add_option_function<std::uint32_t>(
                name, [&b, to](std::uint32_t side) { b.to = to, b.side = side; }, help)
            ->type_name("TEXELS")
            ->check(count(SMALLEST_SIDE, LARGEST_SIDE))
            ->group(group);
    };
    CLI::Option* lightmap =
        atlas("--lightmap", "lightmap",
              "A texture of that width and height on TEXCOORD_1, unlit, with everything that "
              "is seen: light, textures, emission. Irradiance (W/m^2) goes into an .exr beside "
              "the .glb");
    CLI::Option* occlusion =
        atlas("--occlusion", "occlusion",
              "Ambient occlusion as occlusionTexture on TEXCOORD_1 of the file's materials; "
              "lights and cameras stay");
    for (CLI::Option* option : {lightmap, occlusion}) option->excludes(vertices);
    lightmap->excludes(occlusion);
    app.add_option("--with", b.with, help_from("What computes the light (default path)", bake_methods()))
        ->type_name("NAME")
        ->check(one_of(bake_methods()))
        ->group(group);
    app.add_option(
           "--exposure", b.exposure,
           "Multiplies light by 2^EV; what is above 1 then is cut, since files hold no more (default 0)")
        ->type_name("EV")
        ->check(number(-100, 100))
        ->group(group);
    app.add_option("--patches", b.patches,
                   fmt::format("Vertices: triangles of the finer mesh, at least (default {})", b.patches))
        ->type_name("N")
        ->check(count(1))
        ->group(group);
    app.add_option("--patch-size", b.patch_size, "Vertices: longest edge of the finer mesh (default: any)")
        ->type_name("METRES")
        ->check(number(0, HUGE_NUMBER))
        ->group(group);
}

void declare_quality(CLI::App& app, RenderOptions& o) {
    const std::string group = "Quality";
    RenderSettings& s = o.settings;
    app.add_option("--samples", s.samples, fmt::format("Of each texel or patch (default {})", s.samples))
        ->type_name("N")
        ->check(count(1))
        ->group(group);
    app.add_option(
           "--max-bounces", s.max_bounces,
           fmt::format("Indirect bounces; 0: light straight from luminaires (default {})", s.max_bounces))
        ->type_name("N")
        ->check(count(0))
        ->group(group);
    app.add_option("--light-sampler", s.light_sampler,
                   help_from(fmt::format("How a light is picked (default {})", s.light_sampler),
                             light_sampler_options()))
        ->type_name("NAME")
        ->check(one_of(light_sampler_options()))
        ->group(group);
    app.add_option("--ao-distance", s.ao_distance,
                   "Occlusion: its reach (default: a tenth of the scene's diagonal)")
        ->type_name("METRES")
        ->check(number(0, HUGE_NUMBER))
        ->group(group);
    app.add_option("--seed", s.seed, "The same seed gives the same file (default 0)")
        ->type_name("N")
        ->check(count(0))
        ->group(group);
    app.add_option("--time-limit", s.time_limit, "Stop after the sample under way by then (default: none)")
        ->type_name("SECONDS")
        ->check(number(0, HUGE_NUMBER))
        ->group(group);
}

void declare_files(CLI::App& app, Options& o) {
    const std::string group = "Output";
    app.add_option("-o,--output", o.output, "The baked file, .glb")->type_name("FILE.glb")->group(group);
    app.add_option("--report", o.common.report, "JSON: what was baked and how, hashes, device, times, rays")
        ->type_name("FILE.json")
        ->group(group);
    declare_progress(app, o.common);
}

} // namespace

Command bake_command(CLI::App& parent) {
    CLI::App* app = parent.add_subcommand(
        "bake", "Bakes the light of a glTF scene into a glTF file that looks the same without any light");
    app->footer(EXAMPLES);
    const auto options = std::make_shared<Options>();
    options->common.settings.samples = 256; // a texel's noise stays, where a pixel's is averaged by the next
    app->add_option("SCENE", options->common.scene, "A .gltf or .glb file")->required();
    declare_files(*app, *options);
    declare_target(*app, *options);
    declare_quality(*app, options->common);
    declare_light(*app, options->common);
    declare_device(*app, options->common);
    return {app, [options] { return run(*options); }};
}

} // namespace ajar::cli
