#include "ajar/scene_hash.hpp"

#include "base/hash.hpp"

#include <cstring>
#include <span>
#include <type_traits>
#include <vector>

namespace ajar {

namespace {

// Collects values as bytes. Long arrays enter as their own hash, so that memory stays small.
class Digest {
  public:
    template <class T> void add(const T& value) {
        static_assert(std::has_unique_object_representations_v<T> || std::is_floating_point_v<T>,
                      "no padding");
        append(std::as_bytes(std::span(&value, 1)));
    }
    void add(bool value) { add(static_cast<std::uint8_t>(value)); }
    void add(const glm::vec3& v) { add(v.x), add(v.y), add(v.z); }
    void add(const glm::vec4& v) { add(v.x), add(v.y), add(v.z), add(v.w); }
    void add(const glm::mat4& m) {
        for (int c = 0; c < 4; ++c) add(m[c]);
    }
    void add(const std::string& text) {
        add(static_cast<std::uint64_t>(text.size()));
        append(std::as_bytes(std::span(text.data(), text.size())));
    }
    template <class T> void add(const std::vector<T>& values) {
        add(static_cast<std::uint64_t>(values.size()));
        add(content_hash(std::as_bytes(std::span(values.data(), values.size()))));
    }
    template <class... Values> void add_each(const Values&... values) { (add(values), ...); }
    std::string hash() const { return content_hash(bytes_); }

  private:
    void append(std::span<const std::byte> bytes) { bytes_.insert(bytes_.end(), bytes.begin(), bytes.end()); }
    std::vector<std::byte> bytes_;
};

// Structured bindings name every field: a new one does not compile until it is hashed, or left out, here.

void add(Digest& d, const Mesh& mesh) {
    const auto& [name, positions, normals, tangents, uv0, uv1, colors, triangles, materials] = mesh;
    d.add_each(positions, normals, tangents, uv0, uv1, colors, triangles, materials);
}

void add(Digest& d, const Instance& instance) {
    const auto& [name, mesh, to_world, sphere_radius, sphere_center] = instance;
    d.add_each(mesh, to_world, sphere_radius, sphere_center);
}

void add(Digest& d, const TextureUse& use) {
    const auto& [texture, uv_set, uv_row_u, uv_row_v] = use;
    d.add_each(texture, uv_set, uv_row_u, uv_row_v);
}

// Occlusion is kept for `ajar info` alone.
void add(Digest& d, const Material& material) {
    const auto& [name, base_color, base_color_texture, metallic, roughness, metallic_roughness_texture,
                 normal_scale, normal_texture, occlusion_strength, occlusion_texture, emission,
                 emission_texture, ior, specular, specular_color, alpha_mode, alpha_cutoff, double_sided,
                 unlit] = material;
    d.add_each(base_color, metallic, roughness, normal_scale, emission, ior, specular, specular_color,
               alpha_mode, alpha_cutoff, double_sided, unlit);
    for (const TextureUse* use :
         {&base_color_texture, &metallic_roughness_texture, &normal_texture, &emission_texture})
        add(d, *use);
}

void add(Digest& d, const Texture& texture) {
    const auto& [name, image, wrap_u, wrap_v, filter] = texture;
    d.add_each(image, wrap_u, wrap_v, filter);
}

void add(Digest& d, const TextureImage& image) {
    const auto& [name, width, height, rgba] = image;
    d.add_each(width, height, rgba);
}

void add(Digest& d, const Light& light) {
    const auto& [name, kind, intensity, position, direction, range, inner_cone_angle, outer_cone_angle,
                 radius, angular_diameter] = light;
    d.add_each(kind, intensity, position, direction, range, inner_cone_angle, outer_cone_angle, radius,
               angular_diameter);
}

// The name too: --camera NAME is looked up by it.
void add(Digest& d, const Camera& camera) {
    const auto& [name, kind, yfov, ymag, to_world] = camera;
    d.add_each(name, kind, yfov, ymag, to_world);
}

void add(Digest& d, const Environment& environment) {
    const auto& [name, width, height, radiance, scale, rotation] = environment;
    d.add_each(width, height, radiance, scale, rotation);
}

template <class T> void add_all(Digest& d, const std::vector<T>& parts) {
    d.add(static_cast<std::uint64_t>(parts.size()));
    for (const T& part : parts) add(d, part);
}

} // namespace

std::string scene_hash(const Scene& scene) {
    const auto& [name, meshes, instances, materials, textures, images, lights, cameras, camera, environment] =
        scene;
    Digest d;
    add_all(d, meshes);
    add_all(d, instances);
    add_all(d, materials);
    add_all(d, textures);
    add_all(d, images);
    add_all(d, lights);
    add_all(d, cameras);
    d.add(camera);
    d.add(environment.has_value());
    if (environment) add(d, *environment);
    return d.hash();
}

} // namespace ajar
