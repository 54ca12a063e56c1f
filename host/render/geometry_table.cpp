#include "render/geometry_table.hpp"

#include "base/error.hpp"
#include "render/material_table.hpp"
#include "render/surface_words.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <glm/gtc/matrix_inverse.hpp>
#include <tbb/parallel_for.h>

namespace ajar {

namespace {

using namespace shared;

// One hierarchy's triangles before they are ordered.
struct Part {
    std::vector<bvh::Triangle> triangles;
    std::vector<TriangleSource> sources;
};

bool emits(const Scene& scene, const Mesh& mesh) {
    for (const std::uint32_t material : mesh.triangle_materials)
        if (scene.materials[material].emission != glm::vec3(0) && !scene.materials[material].unlit)
            return true;
    return false;
}

// Emissive meshes are always baked: each of their triangles is a light of its own.
std::vector<bool> choose_baked(const Scene& scene, const GeometryOptions& options) {
    std::vector<std::uint32_t> uses(scene.meshes.size());
    std::uint64_t total = 0;
    for (const Instance& i : scene.instances) {
        ++uses[i.mesh];
        total += scene.meshes[i.mesh].triangles.size();
    }
    std::vector<bool> baked(scene.instances.size());
    for (std::size_t i = 0; i < baked.size(); ++i) {
        const std::uint32_t mesh = scene.instances[i].mesh;
        baked[i] =
            total <= options.bake_below_triangles || uses[mesh] == 1 || emits(scene, scene.meshes[mesh]);
    }
    return baked;
}

void append(Part& part, const Scene& scene, std::uint32_t instance, const glm::mat4& to_frame) {
    const Mesh& mesh = scene.meshes[scene.instances[instance].mesh];
    const bool flip = mirrors(to_frame);
    const std::size_t first = part.triangles.size();
    part.triangles.resize(first + mesh.triangles.size());
    part.sources.resize(part.triangles.size());
    tbb::parallel_for(std::size_t{0}, mesh.triangles.size(), [&](std::size_t t) {
        for (int k = 0; k < 3; ++k) {
            const std::uint32_t vertex = mesh.triangles[t][flip && k != 0 ? 3 - k : k];
            part.triangles[first + t].vertices[k] =
                glm::vec3(to_frame * glm::vec4(mesh.positions[vertex], 1));
        }
        part.sources[first + t] = {instance, static_cast<std::uint32_t>(t)};
    });
}

void rows_of(const glm::mat4& m, vec4 (&rows)[3]) {
    for (int r = 0; r < 3; ++r) rows[r] = vec4(m[0][r], m[1][r], m[2][r], m[3][r]);
}

InstanceRecord instance_record(const glm::mat4& to_world, std::uint32_t root, std::uint32_t object) {
    InstanceRecord record{};
    rows_of(to_world, record.to_world);
    rows_of(glm::affineInverse(to_world), record.to_object);
    record.root = root;
    record.flags = mirrors(to_world) ? INSTANCE_FLIPPED : 0;
    record.object = object;
    return record;
}

void fill_records(GeometryTable& table, const Scene& scene, const GeometryOptions& options,
                  const std::vector<Part>& parts) {
    const std::size_t count = table.bvh.order.size();
    table.triangles.resize(count);
    table.sources.resize(count);
    table.surface_words = options.extended_surfaces ? 4 * SURFACE_EXTENDED_TEXELS : 4 * SURFACE_TEXELS;
    table.surfaces.resize(count * table.surface_words);
    for (std::size_t p = 0; p < parts.size(); ++p) {
        const bvh::MeshRange& range = table.bvh.meshes[p];
        tbb::parallel_for(
            range.first_triangle, range.first_triangle + range.triangle_count, [&](std::uint32_t k) {
                const std::uint32_t from = table.bvh.order[k];
                const TriangleSource source = parts[p].sources[from];
                const Instance& instance = scene.instances[source.instance];
                const Mesh& mesh = scene.meshes[instance.mesh];
                const std::uint32_t material = mesh.triangle_materials[source.triangle];
                const bvh::Triangle& vertices = parts[p].triangles[from];
                const std::uint32_t flags = triangle_flags(scene.materials[material], options.cull_backfaces);
                table.triangles[k] = bvh::make_record(vertices, flags, material, source.instance);
                table.sources[k] = source;
                const glm::mat4 to_frame = p == 0 ? instance.to_world : glm::mat4(1);
                write_surface_words(mesh, source.triangle, to_frame, source.instance,
                                    options.extended_surfaces,
                                    &table.surfaces[std::size_t{k} * table.surface_words]);
            });
    }
}

std::uint64_t count_unsure(const GeometryTable& table, const std::vector<bvh::Placement>& placements) {
    std::vector<std::uint64_t> uses(table.bvh.meshes.size());
    uses[0] = 1;
    for (const bvh::Placement& placement : placements) ++uses[placement.mesh];
    std::uint64_t count = 0;
    for (std::size_t m = 0; m < uses.size(); ++m) {
        const bvh::MeshRange& range = table.bvh.meshes[m];
        const auto first = table.triangles.begin() + range.first_triangle;
        count += uses[m] * static_cast<std::uint64_t>(std::count_if(
                               first, first + range.triangle_count,
                               [](const TriangleRecord& t) { return (t.flags & TRIANGLE_ALPHA) != 0; }));
    }
    return count;
}

} // namespace

GeometryTable build_geometry_table(const Scene& scene, const GeometryOptions& options) {
    const std::vector<bool> baked = choose_baked(scene, options);
    std::vector<Part> parts(1); // 0: the world
    std::vector<std::uint32_t> part_of_mesh(scene.meshes.size(), NO_INDEX);
    std::vector<bvh::Placement> placements;
    std::vector<std::uint32_t> placed_instances;
    for (std::uint32_t i = 0; i < scene.instances.size(); ++i) {
        const Instance& instance = scene.instances[i];
        if (scene.meshes[instance.mesh].triangles.empty()) continue;
        // A transform that flattens the mesh cannot be undone: such an instance is baked, its triangles have
        // no area.
        if (baked[i] || glm::determinant(glm::mat3(instance.to_world)) == 0) {
            append(parts[0], scene, i, instance.to_world);
            continue;
        }
        if (part_of_mesh[instance.mesh] == NO_INDEX) {
            part_of_mesh[instance.mesh] = static_cast<std::uint32_t>(parts.size());
            append(parts.emplace_back(), scene, i, glm::mat4(1));
        }
        bvh::Placement placement{part_of_mesh[instance.mesh], {}};
        rows_of(instance.to_world, placement.to_world);
        placements.push_back(placement);
        placed_instances.push_back(i);
    }

    GeometryTable table;
    std::vector<std::span<const bvh::Triangle>> meshes;
    for (const Part& part : parts) meshes.emplace_back(part.triangles);
    table.bvh = bvh::build_scene_bvh(meshes, placements);
    table.world_triangles = table.bvh.meshes[0].triangle_count;
    fill_records(table, scene, options, parts);
    table.unsure_triangles = count_unsure(table, placements);
    table.instances.push_back(instance_record(glm::mat4(1), table.bvh.meshes[0].root, 0));
    for (const std::uint32_t p : table.bvh.placement_order) {
        const std::uint32_t i = placed_instances[p];
        table.instances.push_back(
            instance_record(scene.instances[i].to_world, table.bvh.meshes[placements[p].mesh].root, i));
    }
    return table;
}

bool wants_extended_surfaces(const Scene& scene, bool uses_uv1) {
    for (const Mesh& mesh : scene.meshes)
        if (!mesh.tangents.empty() || !mesh.colors.empty() || (uses_uv1 && !mesh.uv1.empty())) return true;
    return false;
}

} // namespace ajar
