#include "radiosity/patch_mesh.hpp"

#include "base/error.hpp"
#include "radiosity/patch_splitter.hpp"

#include <cassert>
#include <cmath>
#include <fmt/format.h>

namespace ajar {

using namespace shared;

namespace {

// One patch for each triangle that has area.
PatchMesh whole_triangles(const Scene& scene) {
    PatchMesh mesh;
    VertexWelder welder(mesh.positions);
    for (std::uint32_t i = 0; i < scene.instances.size(); ++i) {
        const Instance& instance = scene.instances[i];
        const Mesh& shape = scene.meshes[instance.mesh];
        for (std::uint32_t t = 0; t < shape.triangles.size(); ++t) {
            const PatchSource source{i, t, shape.triangle_materials[t],
                                     static_cast<std::uint32_t>(mesh.nodes.size())};
            const glm::uvec3 corners = PatchMesh::mesh_triangle(scene, source);
            glm::vec3 p[3];
            for (int k = 0; k < 3; ++k)
                p[k] = glm::vec3(instance.to_world * glm::vec4(shape.positions[corners[k]], 1));
            const glm::dvec3 origin(p[0]);
            const glm::dvec3 cross = glm::cross(glm::dvec3(p[1]) - origin, glm::dvec3(p[2]) - origin);
            const double length = glm::length(cross);
            Patch patch;
            patch.area = static_cast<float>(0.5 * length);
            if (!(patch.area > 0) || !std::isfinite(patch.area)) continue;
            if (mesh.patches.size() >= MAX_PATCHES)
                throw Error(fmt::format("radiosity: the scene has more than {} triangles", MAX_PATCHES));
            patch.source = static_cast<std::uint32_t>(mesh.sources.size());
            patch.normal = glm::vec3(cross / length);
            patch.corners[1] = {1, 0};
            patch.corners[2] = {0, 1};
            for (int k = 0; k < 3; ++k) patch.vertices[k] = welder.vertex(p[k]);
            mesh.nodes.push_back({static_cast<std::uint32_t>(mesh.patches.size()) | PATCH_LEAF, 0, {}});
            mesh.patches.push_back(patch);
            mesh.sources.push_back(source);
        }
    }
    return mesh;
}

// A triangle without an edge longer than `size` covers at most that of an equilateral one.
void check_count(const PatchMesh& mesh, const PatchOptions& options) {
    double area = 0;
    for (const Patch& patch : mesh.patches) area += patch.area;
    const double size = options.patch_size;
    const double least = size > 0 ? area / (0.25 * std::sqrt(3.0) * size * size) : 0;
    if (least > MAX_PATCHES || options.patches > MAX_PATCHES)
        throw Error(fmt::format("radiosity: {} makes more than {} patches (choose {})",
                                least > MAX_PATCHES ? fmt::format("a patch size of {:g} m", size)
                                                    : fmt::format("{} patches or more", options.patches),
                                MAX_PATCHES, least > MAX_PATCHES ? "a larger one" : "fewer"));
}

} // namespace

glm::uvec3 PatchMesh::mesh_triangle(const Scene& scene, const PatchSource& source) {
    const Instance& instance = scene.instances[source.instance];
    const glm::uvec3 t = scene.meshes[instance.mesh].triangles[source.triangle];
    return mirrors(instance.to_world) ? glm::uvec3(t.x, t.z, t.y) : t;
}

PatchMesh PatchMesh::subdivide(const Scene& scene, const PatchOptions& options) {
    assert(options.patch_size >= 0);
    PatchMesh mesh = whole_triangles(scene);
    check_count(mesh, options);
    PatchSplitter splitter(mesh);
    splitter.want_all();
    if (options.patch_size > 0) splitter.split(options.patch_size, 0xffffffffu, true);
    splitter.split(0, options.patches, true);
    splitter.finish();
    return mesh;
}

std::vector<std::uint32_t> PatchMesh::refine(std::span<const std::uint8_t> marked) {
    assert(marked.size() == patches.size());
    PatchSplitter splitter(*this);
    for (std::uint32_t p = 0; p < marked.size(); ++p)
        if (marked[p] != 0) splitter.want(p);
    splitter.split(0, 0xffffffffu, false);
    return splitter.finish();
}

std::vector<TriangleSource> PatchMesh::triangles() const {
    std::vector<TriangleSource> all;
    all.reserve(sources.size());
    for (const PatchSource& source : sources) all.push_back({source.instance, source.triangle});
    return all;
}

PatchPoint PatchMesh::find(std::uint32_t source, float u, float v) const {
    float b[3] = {1 - u - v, u, v};
    const PatchNode* node = &nodes[sources[source].root];
    while ((node->child & PATCH_LEAF) == 0) {
        std::uint32_t kept = node->edge;
        std::uint32_t moved = (node->edge + 1) % 3;
        const bool second = b[kept] < b[moved];
        if (second) std::swap(kept, moved);
        b[kept] -= b[moved];
        b[moved] *= 2;
        node = &nodes[node->child + (second ? 1 : 0)];
    }
    return {node->child & ~PATCH_LEAF, b[1], b[2]};
}

} // namespace ajar
