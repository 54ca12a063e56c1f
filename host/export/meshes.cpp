#include "export/meshes.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace ajar::gltf_out {

namespace {

// The vertices that a run of triangles has, in their order: what an importer makes of a primitive goes back
// as it was.
std::vector<std::uint32_t> used_vertices(std::span<const glm::uvec3> triangles, std::size_t vertex_count) {
    std::vector<bool> is_used(vertex_count);
    for (const glm::uvec3& t : triangles)
        for (int k = 0; k < 3; ++k) is_used[t[k]] = true;
    std::vector<std::uint32_t> used;
    for (std::uint32_t v = 0; v < vertex_count; ++v)
        if (is_used[v]) used.push_back(v);
    return used;
}

template <class Vec> std::vector<float> gather(const std::vector<Vec>& values,
                                               const std::vector<std::uint32_t>& used,
                                               int components = Vec::length()) {
    std::vector<float> result;
    result.reserve(used.size() * static_cast<std::size_t>(components));
    for (const std::uint32_t v : used)
        for (int c = 0; c < components; ++c) result.push_back(values[v][c]);
    return result;
}

class MeshWriter {
  public:
    MeshWriter(const Scene& scene, const Mesh& mesh, Document& document)
        : scene_(scene), mesh_(mesh), document_(document) {}

    Json primitives() {
        Json result = Json::array();
        const auto& materials = mesh_.triangle_materials;
        for (std::size_t first = 0; first < materials.size();) {
            std::size_t end = first;
            while (end < materials.size() && materials[end] == materials[first]) ++end;
            result.push_back(
                primitive(std::span(mesh_.triangles).subspan(first, end - first), materials[first]));
            first = end;
        }
        if (clamped_)
            document_.warn(
                fmt::format("mesh '{}': vertex colours are cut to [0, 1], which glTF demands", mesh_.name));
        return result;
    }

  private:
    Json primitive(std::span<const glm::uvec3> triangles, std::uint32_t material) {
        const std::vector<std::uint32_t> used = used_vertices(triangles, mesh_.positions.size());
        Json attributes{{"POSITION", document_.floats(gather(mesh_.positions, used), 3, true)},
                        {"NORMAL", document_.floats(gather(mesh_.normals, used), 3)}};
        if (!mesh_.tangents.empty() && scene_.materials[material].normal_texture.used())
            attributes["TANGENT"] = document_.floats(gather(mesh_.tangents, used), 4);
        if (!mesh_.uv0.empty() || !mesh_.uv1.empty()) // a file with a second set has a first
            attributes["TEXCOORD_0"] = mesh_.uv0.empty()
                                           ? document_.floats(std::vector<float>(2 * used.size()), 2)
                                           : document_.floats(gather(mesh_.uv0, used), 2);
        if (!mesh_.uv1.empty()) attributes["TEXCOORD_1"] = document_.floats(gather(mesh_.uv1, used), 2);
        if (!mesh_.colors.empty()) attributes["COLOR_0"] = colors(used);
        std::vector<std::uint32_t> corners;
        for (const glm::uvec3& t : triangles)
            for (int k = 0; k < 3; ++k)
                corners.push_back(static_cast<std::uint32_t>(
                    std::lower_bound(used.begin(), used.end(), t[k]) - used.begin()));
        const auto count = static_cast<std::uint32_t>(used.size());
        return {{"attributes", std::move(attributes)},
                {"indices", document_.indices(corners, count)},
                {"material", material}};
    }

    // Without alpha where nothing is transparent.
    std::uint32_t colors(const std::vector<std::uint32_t>& used) {
        const bool opaque =
            std::all_of(used.begin(), used.end(), [&](std::uint32_t v) { return mesh_.colors[v].w == 1; });
        std::vector<float> values = gather(mesh_.colors, used, opaque ? 3 : 4);
        for (float& value : values) {
            clamped_ = clamped_ || !(value >= 0 && value <= 1);
            value = std::clamp(value, 0.0f, 1.0f);
        }
        return document_.floats(values, opaque ? 3 : 4);
    }

    const Scene& scene_;
    const Mesh& mesh_;
    Document& document_;
    bool clamped_ = false;
};

} // namespace

std::vector<std::uint32_t> add_meshes(const Scene& scene, Document& document) {
    std::vector<bool> is_placed(scene.meshes.size());
    for (const Instance& instance : scene.instances) is_placed[instance.mesh] = true;
    std::vector<std::uint32_t> places(scene.meshes.size(), NO_INDEX);
    for (std::size_t i = 0; i < scene.meshes.size(); ++i) {
        if (!is_placed[i] || scene.meshes[i].triangles.empty()) continue;
        Json mesh;
        set_name(mesh, scene.meshes[i].name);
        mesh["primitives"] = MeshWriter(scene, scene.meshes[i], document).primitives();
        places[i] = document.push("meshes", std::move(mesh));
    }
    return places;
}

} // namespace ajar::gltf_out
