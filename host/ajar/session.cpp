#include "ajar/session.hpp"

#include "ajar/manifest.hpp"
#include "radiosity/patch_picture.hpp"
#include "radiosity/radiosity.hpp"
#include "render/render.hpp"

#include <optional>
#include <utility>

namespace ajar {

struct Session::Impl {
    std::string scene_name;
    std::string scene_hash;
    const Scene& scene;
    const Device& device;
    WarningSink warn;
    Renderer renderer;
    std::optional<RadiosityResult> radiosity{}; // what integrator radiosity shows
};

Session::Session(const SceneFile& scene, const Device& device, const WarningSink& warn)
    : impl_(new Impl{scene.name(), scene.hash(), scene.scene(), device, warn,
                     Renderer(device, scene.scene(), warn)}) {}

Session::~Session() = default;

RadiosityResult Session::solve(const RadiositySettings& settings, const ProgressSink& progress) {
    RadiositySolution solution =
        solve_radiosity(impl_->device, impl_->scene, settings, progress, impl_->warn);
    impl_->renderer.show(patch_picture(solution));
    impl_->radiosity = {std::move(solution.stats), std::move(solution.history)};
    return *impl_->radiosity;
}

RenderResult Session::render(const RenderSettings& settings, const ProgressSink& progress) {
    const bool shows_solution = settings.integrator == "radiosity";
    if (shows_solution && !impl_->radiosity) {
        RadiositySettings defaults;
        defaults.render = settings;
        solve(defaults, progress);
    }
    RenderOutput output = impl_->renderer.render(settings, progress);
    const Manifest manifest{impl_->scene_name, impl_->scene_hash,
                            impl_->scene,      impl_->device,
                            output.stats,      shows_solution ? &*impl_->radiosity : nullptr};
    RenderResult result;
    result.image = std::move(output.image);
    for (auto& entry : reproduction_metadata(manifest)) result.image.metadata.push_back(std::move(entry));
    result.manifest = manifest_json(manifest);
    result.samples = output.stats.samples;
    result.interrupted = output.stats.interrupted;
    result.out_of_time = output.stats.out_of_time;
    result.prepare_seconds = output.stats.prepare_seconds;
    result.render_seconds = output.stats.render_seconds;
    result.rays = output.stats.extension_rays + output.stats.shadow_rays;
    result.shadow_rays = output.stats.shadow_rays;
    result.learning_seconds = output.stats.learning_seconds;
    result.shadow_rays_open = output.stats.shadow_rays_open;
    result.invalid_samples = output.stats.invalid_samples;
    result.first_invalid[0] = output.stats.invalid_pixel & 0xffff;
    result.first_invalid[1] = output.stats.invalid_pixel >> 16;
    result.first_invalid[2] = output.stats.invalid_sample;
    result.saturated_samples = output.stats.saturated_samples;
    result.exhausted_loops = output.stats.exhausted_loops;
    return result;
}

RenderResult render(const SceneFile& scene, const Device& device, const RenderSettings& settings,
                    const ProgressSink& progress) {
    Session session(scene, device);
    return session.render(settings, progress);
}

} // namespace ajar
