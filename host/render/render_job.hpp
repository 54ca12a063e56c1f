// One render under way: passes over chunks of the film until the samples are done.
#pragma once

#include "gpu/kernel.hpp"
#include "render/film.hpp"
#include "render/gpu_scene.hpp"
#include "render/integrator.hpp"
#include "render/learned_visibility.hpp"
#include "render/pass_runner.hpp"
#include "render/patch_table.hpp"
#include "render/path_pool.hpp"
#include "shaders/kernels/accumulate.glsl.h"
#include "shaders/kernels/aov.glsl.h"
#include "shaders/kernels/generate.glsl.h"
#include "shaders/kernels/place.glsl.h"

#include <optional>

namespace ajar {

class RenderJob {
  public:
    // `visibility`: for a light sampler that needs it, learned first if it is not yet. `elements`: where
    // paths begin, the image then has a pixel for each, in rows; none: at the camera. `patches`: for an
    // integrator that shows them.
    RenderJob(const gpu::Device& device, const Scene& scene, const GpuScene& gpu_scene,
              const RenderSettings& settings, LearnedVisibility* visibility,
              std::span<const shared::SurfaceElement> elements = {}, const PatchTable* patches = nullptr);

    RenderOutput run(const ProgressSink& progress);

  private:
    gpu::Specialization specialization() const;
    void add_begin(Steps& steps) const;
    void add_steps();
    void write_frame(std::uint32_t seed, std::uint32_t sequence_samples);
    bool learn(const ProgressSink& progress);
    bool run_samples(PassRunner& runner, std::uint32_t first_sample, std::uint32_t count,
                     const std::function<bool()>& keep_going);
    void fill_stats(RenderStats& stats) const;
    std::uint32_t pixel_groups(const shared::SegmentArgs& slice) const {
        const std::uint32_t pixels = (slice.segment_count * pool_.segment_paths()) >> slice.samples_log2;
        return (pixels + device_.workgroup_size() - 1) / device_.workgroup_size();
    }

    const gpu::Device& device_;
    RenderSettings settings_; // nothing in it is left to a default
    Camera camera_;
    Film film_;
    PathPool pool_;
    gpu::Bindings bindings_;
    gpu::Commands commands_;
    gpu::Buffer diagnostics_;
    gpu::Buffer frame_buffer_;
    const GpuScene& gpu_scene_;
    LearnedVisibility* visibility_; // none: the light sampler needs none
    const PatchTable* patches_;     // none: the integrator shows none
    IntegratorContext context_;
    gpu::Buffer elements_;
    std::optional<gpu::Kernel<shared::PlaceArgs>> place_;       // where there are elements
    std::optional<gpu::Kernel<shared::GenerateArgs>> generate_; // where there are none
    gpu::Kernel<shared::AccumulateArgs> accumulate_;
    std::optional<gpu::Kernel<shared::AovArgs>> aov_;
    std::unique_ptr<Integrator> integrator_;
    Steps steps_;
};

} // namespace ajar
