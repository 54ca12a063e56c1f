#include "import/meshes.hpp"

#include "import/extras.hpp"
#include "import/normals.hpp"
#include "import/tangents.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace ajar::gltf {

namespace {

// Appends `values`, which may be missing: then `fill` stands for them as soon as another primitive has some.
template <class T> void append(std::vector<T>& to, const std::vector<T>& values, std::size_t before,
                               std::size_t count, const T& fill) {
    if (to.empty() && values.empty()) return;
    to.resize(before, fill);
    to.insert(to.end(), values.begin(), values.end());
    to.resize(before + count, fill);
}

void append_primitive(const Primitive& primitive, std::uint32_t material, Mesh& mesh) {
    const std::size_t before = mesh.positions.size();
    const std::size_t count = primitive.positions.size();
    append(mesh.positions, primitive.positions, before, count, glm::vec3(0));
    append(mesh.normals, primitive.normals, before, count, glm::vec3(0, 0, 1));
    append(mesh.tangents, primitive.tangents, before, count, glm::vec4(1, 0, 0, 1));
    append(mesh.uv0, primitive.uv[0], before, count, glm::vec2(0));
    append(mesh.uv1, primitive.uv[1], before, count, glm::vec2(0));
    append(mesh.colors, primitive.colors, before, count, glm::vec4(1));
    const auto first = static_cast<std::uint32_t>(before);
    for (const glm::uvec3& t : primitive.triangles) mesh.triangles.push_back(t + first);
    mesh.triangle_materials.resize(mesh.triangles.size(), material);
}

template <class Vec> std::size_t replace_non_finite(std::vector<Vec>& values, float by) {
    std::size_t count = 0;
    for (Vec& v : values)
        for (int c = 0; c < Vec::length(); ++c)
            if (!std::isfinite(v[c])) v[c] = by, ++count;
    return count;
}

} // namespace

std::vector<bool> meshes_in_scene(const Document& document, const Nodes& nodes) {
    std::vector<bool> used(document.count("meshes"));
    for (const std::uint32_t node : nodes.in_scene())
        if (const auto mesh = nodes.object(node).index("mesh", used.size(), "mesh")) used[*mesh] = true;
    return used;
}

std::vector<bool> materials_in_scene(Document& document, const std::vector<bool>& meshes) {
    std::vector<bool> used(document.count("materials"));
    AssetInfo& info = document.info();
    std::size_t points_and_lines = 0;
    for (const JsonObject& mesh : document.root().objects("meshes")) {
        const bool in_scene = meshes[info.meshes++];
        for (const JsonObject& primitive : mesh.objects("primitives")) {
            ++info.primitives;
            const auto material = primitive.index("material", used.size(), "material");
            if (!in_scene) continue;
            if (has_no_triangles(primitive))
                ++points_and_lines;
            else if (material)
                used[*material] = true;
        }
    }
    info.skipped_primitives = points_and_lines;
    if (points_and_lines != 0)
        document.warn(fmt::format("{} primitive{} of points or lines {} skipped", points_and_lines,
                                  points_and_lines == 1 ? "" : "s", points_and_lines == 1 ? "is" : "are"));
    return used;
}

Meshes::Meshes(Document& document, Buffers& buffers, Accessors& accessors, const Nodes& nodes, Scene& scene)
    : document_(document), accessors_(accessors), nodes_(nodes),
      scene_(scene), reader_{document, buffers, accessors}, meshes_(document.root().objects("meshes")),
      skins_(document.root().objects("skins")), sphere_lights_(document, scene),
      file_materials_(scene.materials.size()) {}

void Meshes::add_instance(std::uint32_t node) {
    const JsonObject& object = nodes_.object(node);
    const auto index = object.index("mesh", meshes_.size(), "mesh");
    if (!index) return;
    const auto skin = object.index("skin", skins_.size(), "skin");
    std::vector<float> weights = object.numbers("weights");
    if (weights.empty()) weights = meshes_[*index].numbers("weights");
    // A skin puts its vertices into the world by itself; the node's own transform is ignored.
    const glm::mat4 to_world = skin ? glm::mat4(1) : nodes_.to_world(node);
    if (!std::isnormal(glm::determinant(glm::mat3(to_world)))) { // rays and normals need the inverse
        document_.warn(
            fmt::format("node '{}' is not shown: its scale is zero or out of range", nodes_.name(node)));
        return;
    }
    const std::uint32_t mesh = mesh_of({*index, skin.value_or(NO_INDEX), std::move(weights)});
    if (mesh == NO_INDEX) return;
    scene_.instances.push_back({nodes_.name(node), mesh, to_world});
    const std::string owner = fmt::format("node '{}'", nodes_.name(node));
    if (extras_flag(document_, object, "ajar_sphere", owner) ||
        extras_flag(document_, meshes_[*index], "ajar_sphere", owner))
        sphere_lights_.mark(scene_.instances.back());
}

std::uint32_t Meshes::mesh_of(const Shape& shape) {
    const auto [entry, is_new] = shapes_.try_emplace(shape, NO_INDEX);
    if (!is_new) return entry->second;
    const auto& [index, skin, weights] = shape;
    const JsonObject& object = meshes_[index];
    std::vector<glm::mat4> joints;
    if (skin != NO_INDEX) joints = joint_matrices(skins_[skin], nodes_, accessors_);
    Mesh mesh;
    mesh.name = object.text("name");
    const std::vector<JsonObject> primitives = object.objects("primitives");
    if (primitives.empty()) object.fail("primitives", "is empty or missing");
    for (const JsonObject& primitive : primitives)
        if (!has_no_triangles(primitive)) add_primitive(primitive, shape, joints, mesh);
    if (mesh.triangles.empty()) return NO_INDEX;
    entry->second = static_cast<std::uint32_t>(scene_.meshes.size());
    scene_.meshes.push_back(std::move(mesh));
    return entry->second;
}

void Meshes::add_primitive(const JsonObject& json, const Shape& shape, std::span<const glm::mat4> joints,
                           Mesh& mesh) {
    Primitive primitive = reader_.read(json, !joints.empty());
    if (primitive.triangles.empty()) return;
    apply_morph_targets(json, std::get<2>(shape), reader_, primitive);
    if (!joints.empty()) {
        if (primitive.influences.empty())
            json.fail("attributes", "has no JOINTS_0 and WEIGHTS_0 for its skin");
        apply_skin(json, joints, primitive);
    }
    if (primitive.normals.empty()) {
        document_.charge(primitive.triangles.size() * 3 * sizeof(glm::vec4) * 4, json);
        make_flat_normals(primitive);
    } else {
        repair_normals(primitive);
    }
    const std::size_t replaced = replace_non_finite(primitive.uv[0], 0) +
                                 replace_non_finite(primitive.uv[1], 0) +
                                 replace_non_finite(primitive.colors, 1);
    if (replaced != 0)
        document_.warn(
            fmt::format("mesh '{}': {} texture coordinates or colours are not finite and were replaced",
                        mesh.name, replaced));
    const std::uint32_t material = material_of(json);
    const TextureUse& normal_map = scene_.materials[material].normal_texture;
    if (!normal_map.used()) {
        primitive.tangents.clear();
    } else if (primitive.tangents.empty()) {
        document_.charge(primitive.triangles.size() * 3 * sizeof(glm::vec4) * 6, json);
        make_tangents(normal_map, primitive);
    } else {
        repair_tangents(primitive);
    }
    append_primitive(primitive, material, mesh);
}

// The material of primitives that name none is glTF's default; it is added behind the file's own.
std::uint32_t Meshes::material_of(const JsonObject& primitive) {
    if (const auto index = primitive.index("material", file_materials_, "material")) return *index;
    if (default_material_ == NO_INDEX) {
        default_material_ = static_cast<std::uint32_t>(scene_.materials.size());
        Material material;
        material.name = "default";
        scene_.materials.push_back(material);
    }
    return default_material_;
}

} // namespace ajar::gltf
