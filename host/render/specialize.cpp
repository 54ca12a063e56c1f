#include "render/specialize.hpp"

#include "render/choices.hpp"
#include "shaders/shared/specialization.glsl.h"

#include <algorithm>

namespace ajar {

using namespace shared;

// A driver ends all loops of an invocation after 65,535 iterations (lavapipe of Mesa 22.3), and rays through
// foliage take many: with 64 a thread, none too many through 40,000 triangles with holes, a hundredth of the
// rays through 400,000. More workgroups cost more, as most are idle where few paths are left.
std::uint32_t trace_shares(const gpu::Device& device, const GpuScene& scene, const PathPool& pool) {
    const std::uint64_t triangles = scene.unsure_triangles();
    const std::uint32_t rays = triangles < 1u << 16 ? 64 : triangles < 1u << 19 ? 32 : 16; // a thread
    if (triangles == 0) return 1;
    return std::max(pool.segment_paths() / (device.workgroup_size() * rays), 1u);
}

gpu::Specialization specialize(const gpu::Device& device, const GpuScene& scene, const PathPool& pool,
                               const RenderSettings& settings, std::uint32_t features,
                               bool other_tables_fit) {
    const std::string light_sampler = choose_light_sampler(settings.light_sampler, scene.frame().light_count);
    const bool texels = scene.texel_buffers() != 0 && other_tables_fit && !device.options().force_pointers;
    return {
        {SPEC_WORKGROUP_SIZE, device.workgroup_size()},
        {SPEC_SEGMENT_SIZE, pool.segment_paths()},
        {SPEC_TEXEL_BUFFERS, texels ? 1u : 0u},
        {SPEC_FEATURES, choose_triangle_sampling(settings.triangle_sampling, scene.features()) | features},
        {SPEC_PATH_TEXELS, pool.read_by_texels(device) ? 1u : 0u},
        {SPEC_STACK_REGISTERS, scene.stack_registers()},
        {SPEC_STRATEGY, find_strategy(settings.strategy)},
        {SPEC_HEURISTIC, find_heuristic(settings.heuristic)},
        {SPEC_LIGHT_SAMPLER, find_light_sampler(light_sampler)},
        {SPEC_TRACE_SHARES, trace_shares(device, scene, pool)},
        {SPEC_SAMPLER, find_sampler(settings.sampler)}};
}

} // namespace ajar
