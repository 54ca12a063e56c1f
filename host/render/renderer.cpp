// Renderer: a scene on a device, its tables made again only when a setting that they depend on changes.
#include "render/render.hpp"

#include "base/clock.hpp"
#include "base/error.hpp"
#include "render/choices.hpp"
#include "render/element_materials.hpp"
#include "render/element_radiance.hpp"
#include "render/render_job.hpp"
#include "render/sample_sequence.hpp"
#include "shaders/shared/light.glsl.h"
#include "shaders/shared/specialization.glsl.h"

#include <fmt/format.h>
#include <optional>

namespace ajar {

void check_settings(const RenderSettings& s) {
    if (s.samples == 0) throw Error("samples: must be at least 1");
    if (s.max_bounces > 1000) throw Error(fmt::format("max bounces {}: at most 1000", s.max_bounces));
    if (std::uint64_t{s.first_sample} + s.samples > UINT64_C(1) << 32)
        throw Error("samples: first sample and count go beyond 2^32");
    if (!(s.slice_seconds > 0)) throw Error("slice: must be a positive time");
    sequence_samples(s);
    find_light_rays(s.light_rays); // an unknown name is an error for every integrator, as others are
    find_light_sampler(choose_light_sampler(s.light_sampler, 0));
    find_naive_sampling(s.naive_sampling);
    find_shading(s.shading);
    choose_environment_sampling(s);
}

struct Renderer::Impl {
    const gpu::Device& device;
    const Scene& scene;
    WarningSink warn;
    GpuSceneOptions scene_options{};
    std::optional<GpuScene> gpu_scene{};
    double prepare_seconds = 0;
    RenderSettings learned_with{};
    std::optional<LearnedVisibility> visibility{};
    PatchPicture picture{};
    std::optional<PatchTable> patches{}; // the picture's, in the leaf order of gpu_scene

    void prepare(const RenderSettings& settings);
    std::vector<shared::SurfaceElement> prepare_elements(std::span<const SceneElement> elements,
                                                         RenderSettings& settings);
    LearnedVisibility* visibility_for(const RenderSettings& settings);
    const PatchTable* patches_for(const RenderSettings& settings);
};

// The uploaded scene depends on few settings; it is made again when they change.
void Renderer::Impl::prepare(const RenderSettings& settings) {
    GpuSceneOptions wanted;
    wanted.cull_backfaces = settings.cull_backfaces;
    wanted.background = glm::vec3(settings.background[0], settings.background[1], settings.background[2]);
    wanted.bake_below_triangles = settings.bake_below_triangles;
    if (scene.environment && !scene.environment->radiance.empty())
        wanted.environment_density = choose_environment_sampling(settings);
    prepare_seconds = 0;
    if (gpu_scene && wanted == scene_options) return;
    const Clock::time_point start = Clock::now();
    gpu_scene.reset();
    visibility.reset();
    patches.reset();
    scene_options = wanted;
    gpu_scene.emplace(device, scene, scene_options);
    if (warn && gpu_scene->spheres_left_out() > 0)
        warn(fmt::format(
            "{} of the meshes marked as spheres emit by their triangles: no more than {} can be spheres",
            gpu_scene->spheres_left_out(), shared::MAX_SOFT_LIGHTS));
    prepare_seconds = seconds_since(start);
}

// Elements name triangles of the world: all meshes are baked.
std::vector<shared::SurfaceElement> Renderer::Impl::prepare_elements(std::span<const SceneElement> elements,
                                                                     RenderSettings& settings) {
    settings.bake_below_triangles = UINT64_MAX;
    prepare(settings);
    const SurfaceIndex index(scene, gpu_scene->triangle_sources());
    std::vector<shared::SurfaceElement> on_device;
    on_device.reserve(elements.size());
    for (const SceneElement& element : elements) on_device.push_back(index.element(element));
    return on_device;
}

// What was learned before is kept for renders that differ only in how many samples they take, and when.
LearnedVisibility* Renderer::Impl::visibility_for(const RenderSettings& settings) {
    if (!learns_visibility(settings)) return nullptr;
    RenderSettings wanted = settings;
    wanted.samples = wanted.first_sample = wanted.sequence_samples = 0;
    wanted.time_limit = 0;
    if (!visibility || !visibility->is_frozen() || wanted != learned_with) {
        visibility.reset();
        visibility.emplace(device);
        learned_with = wanted;
    }
    return &*visibility;
}

const PatchTable* Renderer::Impl::patches_for(const RenderSettings& settings) {
    if (!find_integrator(settings.integrator).shows_patches) return nullptr;
    if (!patches)
        patches.emplace(device, gpu_scene->triangle_sources(), picture.divided, picture.nodes, picture.sides);
    return &*patches;
}

Renderer::Renderer(const gpu::Device& device, const Scene& scene, const WarningSink& warn)
    : impl_(new Impl{device, scene, warn}) {
    validate(scene);
}

Renderer::~Renderer() = default;

void Renderer::show(PatchPicture patches) {
    impl_->picture = std::move(patches);
    impl_->patches.reset();
}

RenderOutput Renderer::render(const RenderSettings& settings, const ProgressSink& progress) {
    check_settings(settings);
    RenderSettings used = settings;
    if (find_integrator(used.integrator).shows_patches) {
        if (impl_->picture.sides.empty())
            throw Error(fmt::format("integrator '{}': no patches have been solved for", used.integrator));
        used.bake_below_triangles = UINT64_MAX; // patches are in the world
    }
    impl_->prepare(used);
    RenderJob job(impl_->device, impl_->scene, *impl_->gpu_scene, used, impl_->visibility_for(used), {},
                  impl_->patches_for(used));
    RenderOutput output = job.run(progress);
    output.stats.prepare_seconds = impl_->prepare_seconds;
    return output;
}

ElementRadiance Renderer::irradiance(std::span<const SceneElement> elements, const RenderSettings& settings,
                                     const ProgressSink& progress) {
    check_settings(settings);
    RenderSettings used = settings;
    const std::vector<shared::SurfaceElement> on_device = impl_->prepare_elements(elements, used);
    ElementRadiance result =
        trace_elements(impl_->device, impl_->scene, *impl_->gpu_scene, on_device, used, progress);
    result.stats.prepare_seconds = impl_->prepare_seconds;
    return result;
}

ElementMaterials Renderer::materials(std::span<const SceneElement> elements, const RenderSettings& settings) {
    RenderSettings used = settings;
    const std::vector<shared::SurfaceElement> on_device = impl_->prepare_elements(elements, used);
    return average_materials(impl_->device, *impl_->gpu_scene, on_device, used);
}

} // namespace ajar
