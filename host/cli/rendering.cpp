#include "cli/rendering.hpp"

#include "base/error.hpp"
#include "cli/command.hpp"
#include "render/render.hpp"
#include "shaders/shared/film.glsl.h"

#include <algorithm>
#include <cstdlib>
#include <fmt/format.h>

namespace ajar::cli {

namespace {

std::string samples_text(std::uint64_t count) {
    return count == 1 ? "1 sample" : fmt::format("{} samples", count);
}

} // namespace

void expect_possible(const RenderSettings& settings, std::string_view what) {
    try {
        check_settings(settings);
    } catch (const Error& error) {
        throw UsageError(fmt::format("{}{}", what, error.what()));
    }
}

Device open_device(RenderOptions& o, ProgressDisplay& display) {
    if (!o.no_cache)
        o.device.cache_folder = default_cache_folder(std::getenv("XDG_CACHE_HOME"), std::getenv("HOME"));
    o.device.on_validation = [&display](std::string_view line) {
        display.warning(fmt::format("validation: {}", line));
    };
    return Device(o.device);
}

SceneFile read_scene(RenderOptions& o, ProgressDisplay& display) {
    display.stage("load");
    o.load.aspect = static_cast<float>(o.settings.width) / static_cast<float>(o.settings.height);
    o.load.warn = [&display](std::string_view line) { display.warning(line); };
    SceneFile scene = SceneFile::load(o.scene, o.load);
    if (!o.environment.empty()) scene.set_environment(o.environment, o.environment_options);
    if (o.background) std::copy(o.background->begin(), o.background->end(), o.settings.background);
    return scene;
}

SceneFile load_scene(RenderOptions& o, ProgressDisplay& display) {
    SceneFile scene = read_scene(o, display);
    if (!o.background && !scene.has_light()) {
        scene.set_default_environment();
        display.notice("the scene has no light: lit by a soft grey studio (see --env, --background)");
    }
    return scene;
}

void warn_of_losses(const RenderResult& result, ProgressDisplay& display, std::string_view what) {
    if (result.invalid_samples > 0)
        display.warning(fmt::format("{}{} of NaN, infinite or negative radiance counted as black (the first: "
                                    "pixel {}, {}, sample {})",
                                    what, samples_text(result.invalid_samples), result.first_invalid[0],
                                    result.first_invalid[1], result.first_invalid[2]));
    if (result.saturated_samples > 0)
        display.warning(fmt::format("{}{} brighter than {:.0f} cut there, so the picture is too dark", what,
                                    samples_text(result.saturated_samples), shared::FILM_MAX_SAMPLE));
    if (result.exhausted_loops > 0)
        display.warning(fmt::format("{}{} rays were given up before all was searched that they might hit (a "
                                    "defect: please report it with the scene)",
                                    what, result.exhausted_loops));
}

} // namespace ajar::cli
