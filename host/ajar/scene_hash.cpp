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
    template <class T>
    void add(const T& value) {
        static_assert(std::has_unique_object_representations_v<T> || std::is_floating_point_v<T>, "no padding");
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
    template <class T>
    void add(const std::vector<T>& values) {
        add(static_cast<std::uint64_t>(values.size()));
        add(content_hash(std::as_bytes(std::span(values.data(), values.size()))));
    }
    void add(const TextureUse& use) {
        add(use.texture), add(use.uv_set), add(use.uv_row_u), add(use.uv_row_v);
    }
    std::string hash() const { return content_hash(bytes_); }

  private:
    void append(std::span<const std::byte> bytes) { bytes_.insert(bytes_.end(), bytes.begin(), bytes.end()); }
    std::vector<std::byte> bytes_;
};

void add(Digest& d, const Mesh& mesh) {
    d.add(mesh.positions), d.add(mesh.normals), d.add(mesh.tangents), d.add(mesh.uv0), d.add(mesh.uv1);
    d.add(mesh.colors), d.add(mesh.triangles), d.add(mesh.triangle_materials);
}

void add(Digest& d, const Instance& instance) { d.add(instance.mesh), d.add(instance.to_world); }

void add(Digest& d, const Material& m) {
    d.add(m.base_color), d.add(m.base_color_texture);
    d.add(m.metallic), d.add(m.roughness), d.add(m.metallic_roughness_texture);
    d.add(m.normal_scale), d.add(m.normal_texture);
    d.add(m.emission), d.add(m.emission_texture);
    d.add(m.ior), d.add(m.specular), d.add(m.specular_color);
    d.add(static_cast<std::uint8_t>(m.alpha_mode)), d.add(m.alpha_cutoff), d.add(m.double_sided), d.add(m.unlit);
}

void add(Digest& d, const Texture& t) {
    d.add(t.image), d.add(static_cast<std::uint8_t>(t.wrap_u)), d.add(static_cast<std::uint8_t>(t.wrap_v));
    d.add(static_cast<std::uint8_t>(t.filter));
}

void add(Digest& d, const TextureImage& image) { d.add(image.width), d.add(image.height), d.add(image.rgba); }

void add(Digest& d, const Light& l) {
    d.add(static_cast<std::uint8_t>(l.kind)), d.add(l.intensity), d.add(l.position), d.add(l.direction);
    d.add(l.range), d.add(l.inner_cone_angle), d.add(l.outer_cone_angle);
}

void add(Digest& d, const Camera& c) {
    d.add(c.name), d.add(static_cast<std::uint8_t>(c.kind)), d.add(c.yfov), d.add(c.ymag), d.add(c.to_world);
}

void add(Digest& d, const Environment& e) {
    d.add(e.width), d.add(e.height), d.add(e.radiance), d.add(e.scale), d.add(e.rotation);
}

template <class T>
void add_all(Digest& d, const std::vector<T>& parts) {
    d.add(static_cast<std::uint64_t>(parts.size()));
    for (const T& part : parts) add(d, part);
}

} // namespace

std::string scene_hash(const Scene& scene) {
    Digest d;
    add_all(d, scene.meshes);
    add_all(d, scene.instances);
    add_all(d, scene.materials);
    add_all(d, scene.textures);
    add_all(d, scene.images);
    add_all(d, scene.lights);
    add_all(d, scene.cameras);
    d.add(scene.camera);
    d.add(scene.environment.has_value());
    if (scene.environment) add(d, *scene.environment);
    return d.hash();
}

} // namespace ajar
