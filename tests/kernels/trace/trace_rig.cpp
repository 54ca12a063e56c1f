#include "trace_rig.hpp"

#include <algorithm>
#include <ctime>

namespace ajar::test {
namespace {

using namespace shared;

gpu::Specialization specialization(const gpu::Device& device, const TraceScene& scene,
                                   const bvh::SceneBvh& bvh, const RigOptions& options,
                                   std::uint32_t option) {
    const std::uint32_t features =
        (scene.placements.empty() ? 0 : FEATURE_INSTANCES) | (scene.materials.empty() ? 0 : FEATURE_ALPHA);
    const std::uint32_t workgroup =
        options.workgroup_size != 0 ? options.workgroup_size : device.workgroup_size();
    return {{SPEC_WORKGROUP_SIZE, workgroup},
            {SPEC_SEGMENT_SIZE, options.segment_size},
            {SPEC_TEXEL_BUFFERS, options.texel_buffers ? 1 : 0},
            {SPEC_PATH_TEXELS, options.texel_buffers ? 1 : 0},
            {SPEC_FEATURES, features},
            {SPEC_STACK_REGISTERS, options.stack_in_memory ? 0 : bvh::stack_registers(bvh)},
            {SPEC_TRACE_SHARES, options.trace_shares},
            {SPEC_OPTION, option}};
}

bvh::SceneBvh build(const TraceScene& scene) {
    const std::vector<std::span<const bvh::Triangle>> meshes(scene.meshes.begin(), scene.meshes.end());
    return bvh::build_scene_bvh(meshes, scene.placements);
}

double process_seconds() {
    timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return double(time.tv_sec) + double(time.tv_nsec) * 1e-9;
}

template <class T>
gpu::Buffer upload(const gpu::Device& device, const std::vector<T>& values, std::string_view label) {
    gpu::Buffer buffer(device, std::max<std::size_t>(values.size() * sizeof(T), 16), label);
    buffer.write(std::span<const T>(values));
    return buffer;
}

} // namespace

InstanceRecord instance_record(const bvh::Placement& placement, std::uint32_t root) {
    glm::dmat4 m(1);
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 4; ++column) m[column][row] = placement.to_world[row][column];
    }
    const glm::dmat4 inverse = glm::inverse(m);
    InstanceRecord record{};
    for (int row = 0; row < 3; ++row) {
        record.to_world[row] = placement.to_world[row];
        for (int column = 0; column < 4; ++column)
            record.to_object[row][column] = float(inverse[column][row]);
    }
    record.root = root;
    record.flags = glm::determinant(glm::dmat3(m)) < 0 ? INSTANCE_FLIPPED : 0;
    return record;
}

std::vector<RigOptions> trace_variants(std::uint32_t RigOptions::*option,
                                       std::initializer_list<std::uint32_t> values) {
    std::vector<RigOptions> variants;
    for (const std::uint32_t value : values) {
        for (const bool stack_in_memory : {false, true}) {
            for (const std::uint32_t workgroup : {0u, 16u}) {
                RigOptions variant;
                variant.*option = value;
                variant.stack_in_memory = stack_in_memory;
                variant.workgroup_size = workgroup;
                variants.push_back(variant);
            }
        }
    }
    variants.push_back({.trace_shares = 4});
    variants.push_back({.segment_size = 64, .texel_buffers = false});
    variants.push_back({.segment_size = 1024, .workgroup_size = 64});
    return variants;
}

TraceRig::TraceRig(const gpu::Device& device, const TraceScene& scene, const RigOptions& options)
    : device_(device), options_(options), bvh_(build(scene)), bindings_(device),
      extend_(device, "extend", specialization(device, scene, bvh_, options, options.extend_option)),
      connect_(device, "connect", specialization(device, scene, bvh_, options, options.connect_option)) {
    fill_tables(scene);
    upload_tables(scene);
}

void TraceRig::upload_tables(const TraceScene& scene) {
    nodes_buffer_ = upload(device_, bvh_.nodes, "nodes");
    triangles_buffer_ = upload(device_, triangles_, "triangles");
    surfaces_buffer_ = upload(device_, surfaces_, "surfaces");
    instances_buffer_ = upload(device_, instances_, "instances");
    materials_buffer_ = upload(device_, scene.materials, "materials");
    FrameRecord frame{};
    frame.nodes.address = nodes_buffer_.address();
    frame.triangles.address = triangles_buffer_.address();
    frame.surfaces.address = surfaces_buffer_.address();
    frame.instances.address = instances_buffer_.address();
    frame.materials.address = materials_buffer_.address();
    frame.root = bvh_.root;
    frame.cull_backfaces = scene.cull_backfaces ? 1 : 0;
    frame_ = gpu::Buffer(device_, sizeof(frame), "frame");
    frame_.write(std::as_bytes(std::span(&frame, 1)));
    bindings_.uniform(frame_);
    if (!options_.texel_buffers) return;
    bindings_.table(BIND_NODES, nodes_buffer_);
    bindings_.table(BIND_TRIANGLES, triangles_buffer_);
    bindings_.table(BIND_SURFACES, surfaces_buffer_);
    bindings_.table(BIND_INSTANCES, instances_buffer_);
    bindings_.table(BIND_MATERIALS, materials_buffer_);
}

void TraceRig::fill_tables(const TraceScene& scene) {
    for (std::size_t m = 0; m < scene.meshes.size(); ++m) {
        const bvh::MeshRange& range = bvh_.meshes[m];
        for (std::uint32_t k = 0; k < range.triangle_count; ++k) {
            const std::uint32_t from = bvh_.order[range.first_triangle + k];
            SurfaceRecord surface{};
            surface.light = NO_LIGHT;
            bool sure = scene.materials.empty();
            if (!sure) {
                surface.material = from % std::uint32_t(scene.materials.size());
                const std::uint32_t flags = scene.materials[surface.material].flags;
                sure = (flags & (MATERIAL_MASK | MATERIAL_BLEND)) == 0 &&
                       (!scene.cull_backfaces || (flags & MATERIAL_DOUBLE_SIDED) != 0);
            }
            triangles_.push_back(
                bvh::make_record(scene.meshes[m][from], sure ? 0 : TRIANGLE_ALPHA, surface.material, 0));
            surfaces_.push_back(surface);
        }
    }
    const glm::vec4 x(1, 0, 0, 0), y(0, 1, 0, 0), z(0, 0, 1, 0);
    instances_.push_back(instance_record({0, {x, y, z}}, bvh_.meshes[0].root));
    for (const std::uint32_t p : bvh_.placement_order)
        instances_.push_back(
            instance_record(scene.placements[p], bvh_.meshes[scene.placements[p].mesh].root));
}

SegmentArgs TraceRig::begin(std::size_t rays, bool shadows) {
    const std::uint32_t size = options_.segment_size;
    const auto segments = std::uint32_t((rays + size - 1) / size);
    const std::uint64_t slots = std::uint64_t(segments) * size;
    if (paths_.size_bytes() < slots * sizeof(PathState)) {
        paths_ = gpu::Buffer(device_, slots * sizeof(PathState), "paths");
        shadow_rays_ = gpu::Buffer(device_, slots * sizeof(ShadowRay), "shadow rays");
        segments_ = gpu::Buffer(device_, segments * sizeof(SegmentCounts), "segments");
        radiance_ = gpu::Buffer(device_, slots * sizeof(glm::vec4), "radiance");
        bindings_.storage(BIND_PATHS, paths_);
        bindings_.storage(BIND_SHADOW_RAYS, shadow_rays_);
        bindings_.storage(BIND_SEGMENTS, segments_);
        bindings_.storage(BIND_RADIANCE, radiance_);
        bindings_.table(BIND_PATHS_READ, paths_);
        bindings_.table(BIND_SHADOW_RAYS_READ, shadow_rays_);
        bindings_.table(BIND_RADIANCE_READ, radiance_);
    }
    std::vector<SegmentCounts> counts(segments);
    for (std::uint32_t s = 0; s < segments; ++s) {
        const auto in_segment = std::uint32_t(std::min<std::size_t>(size, rays - std::size_t(s) * size));
        counts[s].paths = shadows ? 0 : in_segment;
        counts[s].shadows = shadows ? in_segment : 0;
    }
    segments_.write(std::span<const SegmentCounts>(counts));
    SegmentArgs args{};
    args.segment_count = segments;
    args.segment_stride = 1;
    args.path_count = std::uint32_t(rays);
    return args;
}

void TraceRig::finish(gpu::Commands& commands, const SegmentArgs& args, RigResult& result) {
    const double start = process_seconds();
    commands.submit();
    result.cpu_seconds = process_seconds() - start;
    for (const SegmentCounts& counts : segments_.read<SegmentCounts>(0, args.segment_count))
        result.exhausted += counts.loops_exhausted;
}

RigResult TraceRig::extend(std::span<const PathState> paths) {
    RigResult result;
    if (paths.empty()) return result;
    const SegmentArgs args = begin(paths.size(), false);
    paths_.write(paths);
    gpu::Commands commands(device_);
    commands.bind(bindings_);
    extend_.dispatch(commands, {args}, args.segment_count * options_.trace_shares);
    finish(commands, args, result);
    result.paths = paths_.read<PathState>(0, paths.size());
    return result;
}

RigResult TraceRig::connect(std::span<const ShadowRay> rays) {
    RigResult result;
    if (rays.empty()) return result;
    const SegmentArgs args = begin(rays.size(), true);
    std::vector<ShadowRay> own(rays.begin(), rays.end());
    for (std::size_t i = 0; i < own.size(); ++i) {
        own[i].home = std::uint32_t(i);
        own[i].contribution = glm::vec3(1, 2, 3);
    }
    shadow_rays_.write(std::span<const ShadowRay>(own));
    radiance_.clear();
    gpu::Commands commands(device_);
    commands.bind(bindings_);
    connect_.dispatch(commands, {args}, args.segment_count * options_.trace_shares);
    finish(commands, args, result);
    for (const glm::vec4& sum : radiance_.read<glm::vec4>(0, own.size())) result.open.push_back(sum.z == 3);
    return result;
}

} // namespace ajar::test
