#include "cli/render_options.hpp"

#include "cli/help.hpp"
#include "cli/numbers.hpp"
#include "cli/radiosity_options.hpp"
#include "image/tonemap.hpp"
#include "render/render.hpp"

#include <array>
#include <charconv>
#include <fmt/format.h>

namespace ajar::cli {

namespace {

constexpr std::uint32_t MAX_SIDE = 65536; // pixels; whether the film fits is for the device to say

void set_size(RenderSettings& settings, const std::string& text) {
    const char* const end = text.data() + text.size();
    const auto [x, width_error] = std::from_chars(text.data(), end, settings.width);
    bool good = width_error == std::errc() && x != end && *x == 'x';
    if (good) {
        const auto [rest, height_error] = std::from_chars(x + 1, end, settings.height);
        good = height_error == std::errc() && rest == end;
    }
    if (!good || settings.width == 0 || settings.height == 0 || settings.width > MAX_SIDE ||
        settings.height > MAX_SIDE)
        throw CLI::ValidationError(fmt::format(
            "--size: '{}' is not WIDTHxHEIGHT, such as 1280x720, of at most {} each", text, MAX_SIDE));
}

void set_background(RenderOptions& options, const std::string& text) {
    const std::vector<std::string> parts = CLI::detail::split(text, ',');
    std::array<float, 3> color{};
    bool good = parts.size() == color.size();
    for (std::size_t i = 0; good && i < color.size(); ++i) {
        good = number(0, HUGE_NUMBER)(parts[i]).empty();
        color[i] = std::strtof(parts[i].c_str(), nullptr);
    }
    if (!good)
        throw CLI::ValidationError(fmt::format("--background: '{}' is not R,G,B of at least 0 each", text));
    options.background = color;
}

void set_filter(RenderSettings& settings, const std::string& name) {
    const auto rows = pixel_filters();
    for (std::size_t i = 0; i < rows.size(); ++i)
        if (rows[i].name == name) settings.filter = static_cast<PixelFilter>(i);
}

} // namespace

void declare_files(CLI::App& app, RenderOptions& o) {
    const std::string group = "Output";
    app.add_option(
           "-o,--output", o.outputs,
           ".exr (linear radiance, every layer), .png or .jpg (tone-mapped, sRGB) or .hdr; may be repeated")
        ->type_name("FILE")
        ->allow_extra_args(false)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
        ->group(group);
    app.add_flag("--float", o.save.full_floats, "EXR: 32-bit floats (default: half where that is enough)")
        ->group(group);
}

void declare_output(CLI::App& app, RenderOptions& o) {
    declare_files(app, o);
    const std::string group = "Output";
    app.add_flag("--aov", o.settings.aovs,
                 "EXR: layers albedo, normal, position, depth, emission, object_id, material_id, samples")
        ->group(group);
    app.add_option(
           "--report", o.report,
           "JSON: settings, hashes of scene and shaders, device, driver, versions, time per kernel, rays")
        ->type_name("FILE.json")
        ->group(group);
}

void declare_progress(CLI::App& app, RenderOptions& o) {
    app.add_option("--progress", o.progress,
                   "auto (default): a line on stderr where that is a terminal; none; json: one object a line "
                   "on stdout")
        ->type_name("MODE")
        ->check(CLI::IsMember({"auto", "json", "none"}).description(""))
        ->group("Output");
}

void declare_display(CLI::App& app, RenderOptions& o) {
    const std::string group = "Output";
    app.add_option("--tonemap", o.save.tonemap, help_from("PNG, JPEG (default linear)", tonemap_operators()))
        ->type_name("NAME")
        ->check(one_of(tonemap_operators()))
        ->group(group);
    app.add_option("--exposure", o.save.exposure, "PNG, JPEG: multiplies radiance by 2^EV (default 0)")
        ->type_name("EV")
        ->check(number(-100, 100))
        ->group(group);
    declare_progress(app, o);
}

void declare_image(CLI::App& app, RenderOptions& o) {
    const std::string group = "Image";
    RenderSettings& s = o.settings;
    app.add_option_function<std::string>(
           "--size", [&s](const std::string& text) { set_size(s, text); },
           fmt::format("Pixels (default {}x{}); the camera's vertical angle holds", s.width, s.height))
        ->type_name("WxH")
        ->group(group);
    app.add_option("--samples", s.samples, fmt::format("Per pixel (default {})", s.samples))
        ->type_name("N")
        ->check(count(1))
        ->group(group);
    app.add_option("--first-sample", s.first_sample,
                   "Of those; with it several runs render parts of one picture, for `ajar merge` (default 0)")
        ->type_name("N")
        ->check(count(0))
        ->group(group);
    app.add_option("--seed", s.seed, "The same seed gives the same image (default 0)")
        ->type_name("N")
        ->check(count(0))
        ->group(group);
    app.add_option("--time-limit", s.time_limit, "Stop after the sample under way by then (default: none)")
        ->type_name("SECONDS")
        ->check(number(0, HUGE_NUMBER))
        ->group(group);
    app.add_option("--max-bounces", s.max_bounces,
                   fmt::format("Indirect bounces; 0: emission and direct light (default {})", s.max_bounces))
        ->type_name("N")
        ->check(count(0))
        ->group(group);
    app.add_option("--rr-depth", s.rr_depth,
                   fmt::format("Bounces before Russian roulette begins (default {})", s.rr_depth))
        ->type_name("N")
        ->check(count(0))
        ->group(group);
    app.add_option_function<std::string>(
           "--filter", [&s](const std::string& name) { set_filter(s, name); },
           help_from("Pixel filter (default box)", pixel_filters()))
        ->type_name("NAME")
        ->check(one_of(pixel_filters()))
        ->group(group);
    app.add_option("--filter-radius", s.filter_radius, "Pixels (default: the filter's own)")
        ->type_name("PIXELS")
        ->check(number(0, 16))
        ->group(group);
}

void declare_method(CLI::App& app, RenderOptions& o) {
    const std::string group = "Method";
    RenderSettings& s = o.settings;
    const auto choice = [&](const char* name, std::string& value, std::string_view what,
                            std::span<const Choice> rows) {
        app.add_option(name, value, help_from(fmt::format("{} (default {})", what, value), rows))
            ->type_name("NAME")
            ->check(one_of(rows))
            ->group(group);
    };
    choice("--integrator", s.integrator, "What is computed", integrators());
    choice("--shading", s.shading, "How integrator radiosity shows its patches", shadings());
    choice("--strategy", s.strategy, "How integrator path finds light", strategies());
    choice("--heuristic", s.heuristic, "How strategy mis weighs the two", heuristics());
    choice("--light-rays", s.light_rays, "Shadow rays at a vertex", light_ray_choices());
    choice("--light-sampler", s.light_sampler, "How a light is picked", light_sampler_options());
    choice("--sampler", s.sampler, "Random numbers", samplers());
    choice("--triangle-sampling", s.triangle_sampling, "How a point on an emissive triangle is picked",
           triangle_samplings());
    choice("--env-sampling", s.environment_sampling, "How a direction to the map of --env is picked",
           environment_samplings());
    choice("--naive-sampling", s.naive_sampling, "How integrator naive picks directions", naive_samplings());
    app.add_option("--clamp", s.clamp,
                   "No channel of a sample is above it; darkens the image, so it is named as biased "
                   "(default: none)")
        ->type_name("X")
        ->check(number(0, HUGE_NUMBER))
        ->group(group);
    app.add_option("--sequence-samples", s.sequence_samples,
                   "Sampler blue-noise: samples of all runs that make one picture (default: --samples)")
        ->type_name("N")
        ->check(count(1))
        ->group(group);
    app.add_option("--ao-distance", s.ao_distance,
                   "Reach of integrator ao (default: a tenth of the scene's diagonal)")
        ->type_name("METRES")
        ->check(number(0, HUGE_NUMBER))
        ->group(group);
}

void declare_scene(CLI::App& app, RenderOptions& o) {
    app.add_option("--camera", o.settings.camera, "Default: the scene's first; a file without any is framed")
        ->type_name("NAME|INDEX")
        ->group("Scene");
    declare_light(app, o);
    app.get_option("--background")
        ->description(
            "Radiance where there is no map (default 0,0,0; without it a scene that has no light gets "
            "a soft grey studio)");
}

void declare_light(CLI::App& app, RenderOptions& o) {
    const std::string group = "Scene";
    app.add_option("--scene", o.load.scene, "Which of the file's scenes (default: the file's own choice)")
        ->type_name("NAME|INDEX")
        ->group(group);
    app.add_option("--env", o.environment, "Environment map, equirectangular: .hdr or .exr")
        ->type_name("FILE")
        ->group(group);
    app.add_option("--env-rotation", o.environment_options.rotation_degrees,
                   "Turns the map about +Y (default 0)")
        ->type_name("DEGREES")
        ->check(number(-HUGE_NUMBER, HUGE_NUMBER))
        ->group(group);
    app.add_option("--env-strength", o.environment_options.strength, "Multiplies the map (default 1)")
        ->type_name("X")
        ->check(number(0, HUGE_NUMBER))
        ->group(group);
    app.add_option_function<std::string>(
           "--background", [&o](const std::string& text) { set_background(o, text); },
           "Radiance where there is no map (default 0,0,0)")
        ->type_name("R,G,B")
        ->group(group);
    app.add_option_function<std::string>(
           "--backfaces", [&o](const std::string& name) { o.settings.cull_backfaces = name == "cull"; },
           "Single-sided surfaces from behind: show (default) or cull, as glTF asks of rasterizers")
        ->type_name("show|cull")
        ->check(CLI::IsMember({"show", "cull"}).description(""))
        ->group(group);
    for (const char* needs : {"--env-rotation", "--env-strength"})
        app.get_option(needs)->needs(app.get_option("--env"));
    app.get_option("--background")->excludes(app.get_option("--env"));
}

void declare_device(CLI::App& app, RenderOptions& o) {
    app.add_option("--device", o.device.select,
                   "Which device `ajar devices` lists (default: discrete GPU, integrated, CPU)")
        ->type_name("N|NAME")
        ->group("Device");
    const std::string group = "Expert (none of these changes the image)";
    const auto positive = [&](const char* name, std::uint32_t& value, const char* help) {
        app.add_option(name, value, help)->type_name("N")->check(count(1))->group(group);
    };
    positive("--pool", o.settings.pool_paths, "Paths in flight (default: by device)");
    positive("--segment", o.settings.segment_paths, "Paths per segment (default: by device)");
    positive("--workgroup", o.device.workgroup_size, "Threads per workgroup (default: by device)");
    app.add_option("--slice", o.settings.slice_seconds,
                   fmt::format("Aimed length of one submission (default {})", o.settings.slice_seconds))
        ->type_name("SECONDS")
        ->check(number(0.001, 60))
        ->group(group);
    app.add_flag("--pointers", o.device.force_pointers, "Read tables through pointers, not texel buffers")
        ->group(group);
    app.add_flag("--validate", o.device.validation,
                 "Load the Vulkan validation layer; its messages are warnings")
        ->group(group);
    app.add_flag("--no-cache", o.no_cache, "Neither read nor write compiled pipelines (in ~/.cache/ajar)")
        ->group(group);
}

void declare(CLI::App& app, RenderOptions& options) {
    app.add_option("SCENE", options.scene, "A .gltf or .glb file")->required();
    declare_output(app, options);
    declare_display(app, options);
    declare_image(app, options);
    declare_method(app, options);
    declare_radiosity(app, options.radiosity);
    declare_plot(app, options.plot);
    declare_scene(app, options);
    declare_device(app, options);
}

} // namespace ajar::cli
