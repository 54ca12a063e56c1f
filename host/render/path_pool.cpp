#include "render/path_pool.hpp"

#include "base/error.hpp"
#include "shaders/shared/bindings.glsl.h"
#include "shaders/shared/path.glsl.h"

#include <algorithm>
#include <bit>
#include <fmt/format.h>
#include <numeric>
#include <thread>

namespace ajar {

namespace {

using namespace shared;

constexpr std::uint32_t MAX_SEGMENTS = 65536; // the interleaving's products stay within 32 bits

// Measured: 512 paths a segment on lavapipe; a GPU wants one workgroup a segment.
std::uint32_t default_segment(const gpu::Device& device) {
    return device.limits().is_cpu ? 512 : std::max(device.workgroup_size(), 64u);
}

// On a CPU, so many that threads rarely wait for each other at the end of a kernel: two give 1.9 times the
// rate of one, 1.6 times with a quarter of it. It costs nothing that 144 bytes a path leave the caches.
std::uint32_t default_pool(const gpu::Device& device) {
    if (!device.limits().is_cpu) return 1u << 20;
    return std::max(std::clamp(std::thread::hardware_concurrency(), 1u, 64u) * (1u << 16), 1u << 18);
}

std::uint64_t from_words(const uint (&words)[2]) { return words[0] | std::uint64_t{words[1]} << 32; }

} // namespace

PathPool::PathPool(const gpu::Device& device, const RenderSettings& settings, std::uint64_t wanted_paths) {
    segment_paths_ = settings.segment_paths != 0 ? settings.segment_paths : default_segment(device);
    if (!std::has_single_bit(segment_paths_) || segment_paths_ > MAX_SEGMENT_SIZE ||
        segment_paths_ % device.workgroup_size() != 0)
        throw Error(
            fmt::format("{} paths per segment: must be a power of two, a multiple of the workgroup's {} "
                        "threads and at most {}",
                        segment_paths_, device.workgroup_size(), MAX_SEGMENT_SIZE));
    const std::uint64_t bindable = device.limits().max_storage_bytes / sizeof(PathState);
    std::uint64_t paths = settings.pool_paths != 0 ? settings.pool_paths : default_pool(device);
    paths = std::clamp<std::uint64_t>(std::min(paths, wanted_paths), 1, bindable);
    segments_ = static_cast<std::uint32_t>(
        std::clamp<std::uint64_t>((paths + segment_paths_ - 1) / segment_paths_, 1,
                                  std::min<std::uint64_t>(MAX_SEGMENTS, bindable / segment_paths_)));
    path_buffer_ = gpu::Buffer(device, this->paths() * sizeof(PathState), "paths");
    shadow_buffer_ = gpu::Buffer(device, this->paths() * sizeof(ShadowRay), "shadow rays");
    segment_buffer_ = gpu::Buffer(device, segments_ * sizeof(SegmentCounts), "segment counters");
    radiance_buffer_ = gpu::Buffer(device, 2 * std::uint64_t{this->paths()} * sizeof(vec4), "path radiances");
}

std::uint64_t PathPool::device_bytes() const {
    return path_buffer_.size_bytes() + shadow_buffer_.size_bytes() + segment_buffer_.size_bytes() +
           radiance_buffer_.size_bytes();
}

void PathPool::bind(gpu::Bindings& bindings) const {
    bindings.storage(BIND_PATHS, path_buffer_);
    bindings.storage(BIND_SHADOW_RAYS, shadow_buffer_);
    bindings.storage(BIND_SEGMENTS, segment_buffer_);
    bindings.storage(BIND_RADIANCE, radiance_buffer_);
    bindings.table(BIND_PATHS_READ, path_buffer_);
    bindings.table(BIND_SHADOW_RAYS_READ, shadow_buffer_);
    bindings.table(BIND_RADIANCE_READ, radiance_buffer_);
}

bool PathPool::read_by_texels(const gpu::Device& device) const {
    return device.limits().is_cpu &&
           gpu::Bindings::table_fits(device, BIND_PATHS_READ, path_buffer_.size_bytes());
}

PoolTotals PathPool::totals() const {
    PoolTotals totals;
    for (const SegmentCounts& s : segment_buffer_.read<SegmentCounts>(0, segments_)) {
        totals.extension_rays += from_words(s.rays_traced);
        totals.shadow_rays += from_words(s.shadows_traced);
        totals.shadow_rays_open += from_words(s.shadows_open);
        totals.exhausted_loops += s.loops_exhausted;
    }
    return totals;
}

std::uint32_t PathPool::interleaving_stride(std::uint32_t segment_count) {
    if (segment_count < 3) return 1;
    auto stride = static_cast<std::uint32_t>(0.6180339887 * segment_count) | 1u;
    while (std::gcd(stride, segment_count) != 1) ++stride;
    return stride;
}

} // namespace ajar
