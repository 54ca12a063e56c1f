#include "scene/scene.hpp"

#include "base/error.hpp"

#include <cmath>
#include <fmt/format.h>
#include <string_view>

namespace ajar {

namespace {

bool finite(const glm::vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

void check_length(const std::string& where, std::string_view what, std::size_t got, std::size_t wanted) {
    if (got != 0 && got != wanted)
        throw Error(fmt::format("{}: has {} {} for {} positions", where, got, what, wanted));
}

void validate_mesh(const Scene& scene, std::size_t index) {
    const Mesh& mesh = scene.meshes[index];
    const std::string where = fmt::format("mesh {} '{}'", index, mesh.name);
    const std::size_t n = mesh.positions.size();
    if (mesh.normals.size() != n)
        throw Error(fmt::format("{}: has {} normals for {} positions", where, mesh.normals.size(), n));
    check_length(where, "tangents", mesh.tangents.size(), n);
    check_length(where, "texture coordinates (set 0)", mesh.uv0.size(), n);
    check_length(where, "texture coordinates (set 1)", mesh.uv1.size(), n);
    check_length(where, "colours", mesh.colors.size(), n);
    for (std::size_t i = 0; i < n; ++i)
        if (!finite(mesh.positions[i])) throw Error(fmt::format("{}: position {} is not finite", where, i));
    if (mesh.triangle_materials.size() != mesh.triangles.size())
        throw Error(fmt::format("{}: has {} material indices for {} triangles", where,
                                mesh.triangle_materials.size(), mesh.triangles.size()));
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const glm::uvec3& t = mesh.triangles[i];
        if (t.x >= n || t.y >= n || t.z >= n)
            throw Error(
                fmt::format("{}: triangle {}: vertex index out of range (the mesh has {})", where, i, n));
        if (mesh.triangle_materials[i] >= scene.materials.size())
            throw Error(fmt::format("{}: triangle {}: material {} does not exist", where, i,
                                    mesh.triangle_materials[i]));
    }
}

void validate_material(const Scene& scene, std::size_t index) {
    const Material& m = scene.materials[index];
    for (const TextureUse* use : {&m.base_color_texture, &m.metallic_roughness_texture, &m.normal_texture,
                                  &m.occlusion_texture, &m.emission_texture})
        if (use->used() && use->texture >= scene.textures.size())
            throw Error(
                fmt::format("material {} '{}': texture {} does not exist", index, m.name, use->texture));
    if (!finite(glm::vec3(m.base_color)) || !finite(m.emission) || !std::isfinite(m.metallic) ||
        !std::isfinite(m.roughness) || !std::isfinite(m.normal_scale))
        throw Error(fmt::format("material {} '{}': a factor is not finite", index, m.name));
}

// Beyond this, the square of a length is no longer a float.
constexpr float FARTHEST = 1e18f; // metres

Bounds mesh_bounds(const Mesh& mesh) {
    Bounds bounds;
    for (const glm::vec3& p : mesh.positions) bounds.include(p);
    return bounds;
}

// The corners of the mesh's box bound everything in it.
void validate_instance(const Instance& instance, const Bounds& box) {
    if (!finite(instance.sphere_center) ||
        !(instance.sphere_radius >= 0 && instance.sphere_radius <= FARTHEST))
        throw Error(fmt::format("node '{}': its sphere is not finite", instance.name));
    for (int c = 0; c < 4; ++c)
        if (!finite(glm::vec3(instance.to_world[c])))
            throw Error(fmt::format("node '{}': its transform is not finite", instance.name));
    for (int corner = 0; corner < 8 && !box.empty(); ++corner) {
        const glm::bvec3 upper(corner & 1, corner & 2, corner & 4);
        const glm::vec3 p(instance.to_world * glm::vec4(glm::mix(box.lower, box.upper, upper), 1));
        for (int k = 0; k < 3; ++k)
            if (!(std::abs(p[k]) <= FARTHEST))
                throw Error(
                    fmt::format("node '{}': reaches too far from the origin ({} m)", instance.name, p[k]));
    }
}

} // namespace

void validate(const Scene& scene) {
    for (std::size_t i = 0; i < scene.meshes.size(); ++i) validate_mesh(scene, i);
    for (std::size_t i = 0; i < scene.materials.size(); ++i) validate_material(scene, i);
    for (std::size_t i = 0; i < scene.textures.size(); ++i)
        if (scene.textures[i].image >= scene.images.size())
            throw Error(fmt::format("texture {}: image {} does not exist", i, scene.textures[i].image));
    for (std::size_t i = 0; i < scene.images.size(); ++i) {
        const TextureImage& image = scene.images[i];
        if (image.width == 0 || image.height == 0 ||
            image.rgba.size() != std::size_t{4} * image.width * image.height)
            throw Error(fmt::format("image {} '{}': {} bytes for {} x {} texels", i, image.name,
                                    image.rgba.size(), image.width, image.height));
    }
    std::vector<Bounds> boxes;
    for (const Mesh& mesh : scene.meshes) boxes.push_back(mesh_bounds(mesh));
    for (const Instance& instance : scene.instances) {
        if (instance.mesh >= scene.meshes.size())
            throw Error(fmt::format("node '{}': mesh {} does not exist", instance.name, instance.mesh));
        validate_instance(instance, boxes[instance.mesh]);
    }
    for (const Light& light : scene.lights)
        if (!finite(light.intensity) || !finite(light.position) || !finite(light.direction))
            throw Error(fmt::format("light '{}': a value is not finite", light.name));
    for (const Light& light : scene.lights)
        if (!(light.radius >= 0 && light.radius <= FARTHEST) ||
            !(light.angular_diameter >= 0 && light.angular_diameter <= 3.1415928f))
            throw Error(
                fmt::format("light '{}': its radius or angular diameter is out of range", light.name));
    if (scene.environment) {
        const Environment& e = *scene.environment;
        if (!e.radiance.empty() && e.radiance.size() != std::size_t{1} * e.width * e.height)
            throw Error(fmt::format("environment '{}': {} texels for {} x {}", e.name, e.radiance.size(),
                                    e.width, e.height));
    }
}

Bounds scene_bounds(const Scene& scene) {
    Bounds bounds;
    for (const Instance& instance : scene.instances) {
        const Mesh& mesh = scene.meshes[instance.mesh];
        for (const glm::uvec3& t : mesh.triangles)
            for (int k = 0; k < 3; ++k)
                bounds.include(glm::vec3(instance.to_world * glm::vec4(mesh.positions[t[k]], 1)));
    }
    return bounds;
}

bool has_light(const Scene& scene) {
    const auto shines = [](const glm::vec3& radiance) {
        return radiance.x > 0 || radiance.y > 0 || radiance.z > 0;
    };
    if (scene.environment && shines(scene.environment->scale)) return true;
    for (const Light& light : scene.lights)
        if (shines(light.intensity)) return true;
    std::vector<bool> is_placed(scene.meshes.size());
    for (const Instance& instance : scene.instances) is_placed[instance.mesh] = true;
    for (std::size_t i = 0; i < scene.meshes.size(); ++i) {
        if (!is_placed[i]) continue;
        for (const std::uint32_t material : scene.meshes[i].triangle_materials)
            if (scene.materials[material].unlit || shines(scene.materials[material].emission)) return true;
    }
    return false;
}

std::uint64_t memory_bytes(const Scene& scene) {
    const auto bytes = [](const auto& values) { return std::uint64_t{values.size()} * sizeof(values[0]); };
    std::uint64_t total = bytes(scene.instances) + bytes(scene.materials) + bytes(scene.lights);
    for (const Mesh& mesh : scene.meshes)
        total += bytes(mesh.positions) + bytes(mesh.normals) + bytes(mesh.tangents) + bytes(mesh.uv0) +
                 bytes(mesh.uv1) + bytes(mesh.colors) + bytes(mesh.triangles) +
                 bytes(mesh.triangle_materials);
    for (const TextureImage& image : scene.images) total += bytes(image.rgba);
    if (scene.environment) total += bytes(scene.environment->radiance);
    return total;
}

Camera framing_camera(const Scene& scene, float aspect) {
    Camera camera;
    camera.name = "automatic";
    camera.yfov = glm::radians(40.0f);
    const Bounds bounds = scene_bounds(scene);
    const glm::vec3 center = bounds.empty() ? glm::vec3(0) : 0.5f * (bounds.lower + bounds.upper);
    const glm::vec3 half_size = bounds.empty() ? glm::vec3(0.5f) : 0.5f * (bounds.upper - bounds.lower);
    const glm::vec3 back = glm::normalize(glm::vec3(0.45f, 0.35f, 1.0f)); // three-quarter view from the front
    const glm::vec3 x = glm::normalize(glm::cross(glm::vec3(0, 1, 0), back));
    const glm::vec3 y = glm::cross(back, x);
    // The nearest place along `back` from which every corner of the box lies within the middle 95 % of the
    // view.
    const float tan_y = 0.95f * std::tan(0.5f * camera.yfov);
    const float tan_x = tan_y * aspect;
    float distance = 1e-6f;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::vec3 sign((corner & 1) != 0 ? 1 : -1, (corner & 2) != 0 ? 1 : -1,
                             (corner & 4) != 0 ? 1 : -1);
        const glm::vec3 p = sign * half_size;
        const float aside = std::max(std::abs(glm::dot(p, x)) / tan_x, std::abs(glm::dot(p, y)) / tan_y);
        distance = std::max(distance, aside + glm::dot(p, back));
    }
    const glm::vec3 eye = center + distance * back;
    camera.to_world = glm::mat4(glm::vec4(x, 0), glm::vec4(y, 0), glm::vec4(back, 0), glm::vec4(eye, 1));
    return camera;
}

} // namespace ajar
