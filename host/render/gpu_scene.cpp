#include "render/gpu_scene.hpp"

#include "render/emissive_triangles.hpp"
#include "render/geometry_table.hpp"
#include "render/light_table.hpp"
#include "render/material_table.hpp"
#include "shaders/shared/bindings.glsl.h"
#include "shaders/shared/specialization.glsl.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

namespace ajar {

using namespace shared;

namespace {

// Never empty, and whole texels.
template <class T>
gpu::Buffer make_table(const gpu::Device& device, std::span<const T> values, const char* label) {
    gpu::Buffer buffer(device, std::max<std::uint64_t>((values.size_bytes() + 15) / 16 * 16, 16), label);
    if (!values.empty()) buffer.write(values);
    return buffer;
}

// Both kinds of records in one table; each is a whole number of texels.
std::vector<std::uint32_t> material_words(const MaterialTable& table) {
    const std::size_t first = table.materials.size() * sizeof(MaterialRecord);
    const std::size_t second = table.textures.size() * sizeof(TextureRecord);
    std::vector<std::uint32_t> words((first + second) / 4);
    if (first != 0) std::memcpy(words.data(), table.materials.data(), first);
    if (second != 0) std::memcpy(words.data() + first / 4, table.textures.data(), second);
    return words;
}

} // namespace

struct GpuScene::Host {
    MaterialTable materials;
    GeometryTable geometry;
    LightTable lights;
    EnvironmentTable environment;
};

GpuScene::GpuScene(const gpu::Device& device, const Scene& scene, const GpuSceneOptions& options) {
    Host host;
    host.materials = build_material_table(scene);
    features_ = host.materials.features;
    frame_.textures_first = static_cast<std::uint32_t>(host.materials.materials.size()) * MATERIAL_TEXELS;
    frame_.cull_backfaces = options.cull_backfaces ? 1 : 0;
    build_geometry(scene, options, host);
    std::optional<Environment> environment = scene.environment;
    if (!environment && options.background != glm::vec3(0)) environment.emplace().scale = options.background;
    place_environment(environment, options.environment_density, host);
    build_lights(scene, environment, host, options.dark_triangles);
    upload(device, host);
    triangle_sources_ = std::move(host.geometry.sources);
}

void GpuScene::build_geometry(const Scene& scene, const GpuSceneOptions& options, Host& host) {
    GeometryOptions geometry_options;
    geometry_options.cull_backfaces = options.cull_backfaces;
    geometry_options.extended_surfaces = wants_extended_surfaces(scene, host.materials.uses_uv1);
    geometry_options.bake_below_triangles = options.bake_below_triangles;
    host.geometry = build_geometry_table(scene, geometry_options);
    bvh_seconds_ = host.geometry.bvh.stats.seconds;
    if (host.geometry.instances.size() > 1) features_ |= FEATURE_INSTANCES;
    stack_registers_ = bvh::stack_registers(host.geometry.bvh);
    suits_shadow_packets_ = bvh::suits_shadow_packets(host.geometry.bvh);
    unsure_triangles_ = host.geometry.unsure_triangles;
    if (unsure_triangles_ > 0) features_ |= FEATURE_ALPHA;
    if (geometry_options.extended_surfaces) features_ |= FEATURE_EXTENDED_SURFACE;
    frame_.root = host.geometry.bvh.root;
    frame_.instance_count = static_cast<std::uint32_t>(host.geometry.instances.size());

    const Bounds bounds = scene_bounds(scene);
    frame_.scene_radius = 1;
    if (bounds.empty()) return;
    frame_.scene_center = 0.5f * (bounds.lower + bounds.upper);
    frame_.scene_radius = std::max(0.5f * glm::length(bounds.upper - bounds.lower), 1e-30f);
}

void GpuScene::place_environment(const std::optional<Environment>& chosen, EnvironmentDensity density,
                                 Host& host) {
    frame_.environment_cos = 1;
    if (!chosen) return;
    const Environment& environment = *chosen;
    if (environment.radiance.empty()) {
        frame_.background = environment.scale;
        return;
    }
    host.environment = build_environment_table(environment, density);
    frame_.environment_width = host.environment.width;
    frame_.environment_height = host.environment.height;
    frame_.environment_scale = environment.scale;
    frame_.environment_cos = std::cos(environment.rotation);
    frame_.environment_sin = std::sin(environment.rotation);
}

void GpuScene::build_lights(const Scene& scene, const std::optional<Environment>& environment, Host& host,
                            bool dark_triangles) {
    const std::vector<EmissiveSphere> spheres = collect_emissive_spheres(scene);
    std::vector<EmissiveTriangle> emitters;
    if (!dark_triangles) emitters = collect_emissive_triangles(scene, host.geometry, spheres);
    const auto light_of = [&](std::size_t triangle) -> std::uint32_t& {
        return host.geometry
            .surfaces[triangle * host.geometry.surface_words + offsetof(SurfaceRecord, light) / 4];
    };
    for (std::uint32_t i = 0; i < emitters.size(); ++i) light_of(emitters[i].triangle) = i;
    const auto marked = [](const Instance& i) { return i.sphere_radius > 0; };
    spheres_left_out_ =
        static_cast<std::uint32_t>(std::count_if(scene.instances.begin(), scene.instances.end(), marked) -
                                   static_cast<std::ptrdiff_t>(spheres.size()));
    std::vector<bool> is_sphere(scene.instances.size());
    for (const EmissiveSphere& sphere : spheres) is_sphere[sphere.instance] = true;
    for (std::uint32_t k = 0; k < host.geometry.world_triangles; ++k)
        if (dark_triangles || is_sphere[host.geometry.sources[k].instance]) light_of(k) = LIGHT_ELSEWHERE;
    Scene lighting; // what the table looks at
    lighting.lights = scene.lights;
    lighting.environment = environment;
    host.lights = build_light_table(lighting, emitters, frame_.scene_radius, spheres, host.environment.share);
    features_ |= host.lights.features;
    if (dark_triangles) features_ |= FEATURE_SOFT_LIGHTS; // heeds LIGHT_ELSEWHERE
    host.lights.describe(frame_);
    light_tree_seconds_ = host.lights.tree.seconds;
}

void GpuScene::upload(const gpu::Device& device, const Host& host) {
    const auto at = [&](std::uint32_t binding) -> gpu::Buffer& {
        return tables_[binding - BIND_TABLE_FIRST];
    };
    const GeometryTable& geometry = host.geometry;
    const std::vector<std::uint32_t> materials = material_words(host.materials);
    const std::vector<glm::uvec4> lights = host.lights.words();
    at(BIND_NODES) = make_table(device, std::span(geometry.bvh.nodes), "hierarchy");
    at(BIND_TRIANGLES) = make_table(device, std::span(geometry.triangles), "triangles");
    at(BIND_SURFACES) = make_table(device, std::span(geometry.surfaces), "surfaces");
    at(BIND_INSTANCES) = make_table(device, std::span(geometry.instances), "instances");
    at(BIND_MATERIALS) = make_table(device, std::span(materials), "materials");
    at(BIND_TEXELS) = make_table(device, std::span(host.materials.texels), "texels");
    at(BIND_LIGHTS) = make_table(device, std::span(lights), "lights");
    at(BIND_ENVIRONMENT) = make_table(device, std::span(host.environment.words), "environment");
    for (std::uint32_t b = BIND_TABLE_FIRST; b <= BIND_TABLE_LAST; ++b)
        if (!gpu::Bindings::table_fits(device, b, at(b).size_bytes())) texel_buffers_ = 0;

    frame_.nodes.address = at(BIND_NODES).address();
    frame_.triangles.address = at(BIND_TRIANGLES).address();
    frame_.surfaces.address = at(BIND_SURFACES).address();
    frame_.instances.address = at(BIND_INSTANCES).address();
    frame_.materials.address = at(BIND_MATERIALS).address();
    frame_.texels.address = at(BIND_TEXELS).address();
    frame_.lights.address = at(BIND_LIGHTS).address();
    frame_.environment.address = at(BIND_ENVIRONMENT).address();
}

void GpuScene::bind(gpu::Bindings& bindings) const {
    for (std::uint32_t b = BIND_TABLE_FIRST; b <= BIND_TABLE_LAST; ++b)
        bindings.table(b, tables_[b - BIND_TABLE_FIRST]);
}

std::uint64_t GpuScene::device_bytes() const {
    std::uint64_t bytes = 0;
    for (const gpu::Buffer& table : tables_) bytes += table.size_bytes();
    return bytes;
}

} // namespace ajar
