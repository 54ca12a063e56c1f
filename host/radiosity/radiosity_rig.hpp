// What the kernels of radiosity are dispatched with: the scene and its patches on a device.
#pragma once

#include "gpu/commands.hpp"
#include "gpu/kernel.hpp"
#include "radiosity/patch_mesh.hpp"
#include "render/gpu_scene.hpp"
#include "render/patch_table.hpp"
#include "render/path_pool.hpp"
#include "shaders/shared/element.glsl.h"
#include "shaders/shared/radiosity.glsl.h"

#include <cstdint>
#include <vector>

namespace ajar {

struct RadiosityRig {
    // `gpu_scene`: all instances baked. `settings`: as RadiositySettings::render. All must outlive this.
    RadiosityRig(const gpu::Device& device, const Scene& scene, const GpuScene& gpu_scene,
                 const PatchMesh& mesh, const RenderSettings& settings, std::uint32_t rays);

    std::uint32_t side_count() const { return static_cast<std::uint32_t>(elements.size()); }
    std::uint32_t groups(std::uint32_t threads) const {
        return (threads + device.workgroup_size() - 1) / device.workgroup_size();
    }
    // Of kernels that look at nothing but their arguments, and at a vector that is bound.
    gpu::Specialization plain(std::uint32_t option = 0) const;
    // BIND_SIDE_VALUES, for the dispatches that follow; nothing may be recorded that has not been submitted.
    void bind_values(const gpu::Buffer& vector) { bindings_.table(shared::BIND_SIDE_VALUES, vector); }
    std::uint64_t device_bytes() const;

    const gpu::Device& device;
    const PatchMesh& mesh;
    const RenderSettings& settings;
    std::vector<shared::SurfaceElement> elements; // by side
    PathPool pool;
    std::uint32_t trace_shares;
    gpu::Buffer element_buffer;
    gpu::Commands commands;
    gpu::Specialization specialization; // of kernels over the scene

  private:
    PatchTable patches_;
    gpu::Buffer frame_;
    gpu::Bindings bindings_;
};

} // namespace ajar
