// The paths in flight: their buffers, and how they are cut into segments (shaders/shared/path.glsl.h).
#pragma once

#include "gpu/bindings.hpp"
#include "render/settings.hpp"

#include <cstdint>

namespace ajar {

struct PoolTotals {
    std::uint64_t extension_rays = 0;
    std::uint64_t shadow_rays = 0;
    std::uint64_t shadow_rays_open = 0;
    std::uint64_t exhausted_loops = 0;
};

class PathPool {
  public:
    // No larger than `wanted_paths` asks for. Throws Error when settings ask for what the device cannot hold.
    PathPool(const gpu::Device& device, const RenderSettings& settings, std::uint64_t wanted_paths);

    std::uint32_t paths() const { return segments_ * segment_paths_; }
    std::uint32_t segments() const { return segments_; }
    std::uint32_t segment_paths() const { return segment_paths_; } // a power of two
    std::uint64_t device_bytes() const;
    void bind(gpu::Bindings& bindings) const;
    // Whether kernels should read paths through texel buffers: on lavapipe a storage buffer's load is a loop
    // over lanes.
    bool read_by_texels(const gpu::Device& device) const;

    // Sums of the segments' counters since the pool was made or they were cleared.
    PoolTotals totals() const;
    void clear_totals() { segment_buffer_.clear(); }

    // A stride coprime to `segment_count`, near the golden section: consecutive workgroups land far apart.
    static std::uint32_t interleaving_stride(std::uint32_t segment_count);

  private:
    std::uint32_t segment_paths_;
    std::uint32_t segments_;
    gpu::Buffer path_buffer_;
    gpu::Buffer shadow_buffer_;
    gpu::Buffer segment_buffer_;
    gpu::Buffer radiance_buffer_;
};

} // namespace ajar
