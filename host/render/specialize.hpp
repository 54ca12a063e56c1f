// What the kernels that follow paths are specialised with.
#pragma once

#include "gpu/kernel.hpp"
#include "render/gpu_scene.hpp"
#include "render/path_pool.hpp"
#include "render/settings.hpp"

#include <cstdint>

namespace ajar {

// SPEC_TRACE_SHARES: workgroups a segment for kernels that trace.
std::uint32_t trace_shares(const gpu::Device& device, const GpuScene& scene, const PathPool& pool);

// `features`: FEATURE_* bits beside the scene's. `other_tables_fit`: whether tables that are not the scene's
// can be texel buffers; if not, all tables are read through pointers.
gpu::Specialization specialize(const gpu::Device& device, const GpuScene& scene, const PathPool& pool,
                               const RenderSettings& settings, std::uint32_t features, bool other_tables_fit);

} // namespace ajar
