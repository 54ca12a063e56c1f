// Runs the production kernels extend and connect on rays of the caller's choice, over a scene of plain
// triangles.
#pragma once

#include "bvh/bvh.hpp"
#include "gpu/kernel.hpp"
#include "shaders/kernels/connect.glsl.h"
#include "shaders/kernels/extend.glsl.h"
#include "shaders/shared/bindings.glsl.h"
#include "shaders/shared/frame.glsl.h"
#include "shaders/shared/geometry.glsl.h"
#include "shaders/shared/material.glsl.h"
#include "shaders/shared/path.glsl.h"
#include "shaders/shared/specialization.glsl.h"

namespace ajar::test {

// Meshes and their placements; mesh 0 is the world.
struct TraceScene {
    std::vector<std::vector<bvh::Triangle>> meshes;
    std::vector<bvh::Placement> placements;
    // Triangle k of each mesh is of material k modulo their number, and has to be looked at when it is hit
    // unless that is opaque; none: all is opaque.
    std::vector<shared::MaterialRecord> materials = {};
    bool cull_backfaces = false;
};

struct RigOptions {
    std::uint32_t segment_size = 256;
    std::uint32_t workgroup_size = 0; // 0: the device's
    std::uint32_t trace_shares = 1;
    bool texel_buffers = true;
    std::uint32_t extend_option = shared::EXTEND_BOUNCE;
    std::uint32_t connect_option = shared::CONNECT_APART;
    bool stack_in_memory = false; // else as the hierarchy asks
};

// Every way through a kernel: each value of its option, tables as texels and as pointers, rays replaced (8
// threads) and seen through (16), stacks in registers and in memory, segments of several sizes.
std::vector<RigOptions> trace_variants(std::uint32_t RigOptions::*option,
                                       std::initializer_list<std::uint32_t> values);

struct RigResult {
    std::vector<shared::PathState> paths;
    std::vector<bool> open;
    std::uint64_t exhausted = 0;
    double cpu_seconds = 0; // that the process spent while the kernel ran: the time of a device that is a CPU
};

class TraceRig {
  public:
    TraceRig(const gpu::Device& device, const TraceScene& scene, const RigOptions& options);

    // Traces paths[i] from its origin along its direction.
    RigResult extend(std::span<const shared::PathState> paths);
    // Traces shadow rays; `home` and `contribution` are overwritten.
    RigResult connect(std::span<const shared::ShadowRay> rays);

    const bvh::SceneBvh& bvh() const { return bvh_; }
    // In leaf order.
    const std::vector<shared::TriangleRecord>& triangles() const { return triangles_; }
    std::uint32_t first_triangle(std::uint32_t mesh) const { return bvh_.meshes[mesh].first_triangle; }
    const std::vector<shared::InstanceRecord>& instances() const { return instances_; }

  private:
    void fill_tables(const TraceScene& scene);
    void upload_tables(const TraceScene& scene);
    shared::SegmentArgs begin(std::size_t rays, bool shadows);
    void finish(gpu::Commands& commands, const shared::SegmentArgs& args, RigResult& result);

    const gpu::Device& device_;
    RigOptions options_;
    bvh::SceneBvh bvh_;
    std::vector<shared::TriangleRecord> triangles_;
    std::vector<shared::InstanceRecord> instances_;
    std::vector<shared::SurfaceRecord> surfaces_;
    gpu::Buffer nodes_buffer_, triangles_buffer_, surfaces_buffer_, instances_buffer_, materials_buffer_,
        frame_;
    gpu::Buffer paths_, shadow_rays_, segments_, radiance_;
    gpu::Bindings bindings_;
    gpu::Kernel<shared::ExtendArgs> extend_;
    gpu::Kernel<shared::ConnectArgs> connect_;
};

// A placement as the kernels know it.
shared::InstanceRecord instance_record(const bvh::Placement& placement, std::uint32_t root);

} // namespace ajar::test
