#include "bake/surface_means.hpp"

#include "bake/texture_lookup.hpp"

#include <algorithm>

namespace ajar {

namespace {

constexpr int POINTS = 4; // a side of the grid on each piece

// Weights of the second and third vertex, on the grid; where the piece reaches beyond its triangle, on the
// triangle's border, as paths begin (shaders/geometry/element.glsl).
glm::vec2 point_on(const SceneElement& element, int i, int j) {
    glm::vec2 w((static_cast<float>(i) + 0.5f) / POINTS, (static_cast<float>(j) + 0.5f) / POINTS);
    if ((element.flags & shared::ELEMENT_QUAD) == 0 && w.x + w.y > 1)
        w = 1.0f - w; // folded into the triangle
    const glm::vec2 at = glm::max(element.origin + w.x * element.edge_a + w.y * element.edge_b, 0.0f);
    return at.x + at.y > 1 ? at / (at.x + at.y) : at;
}

template <class T>
T at_point(const std::vector<T>& values, const glm::uvec3& t, const glm::vec2& at, const T& none) {
    if (values.empty()) return none;
    return (1 - at.x - at.y) * values[t.x] + at.x * values[t.y] + at.y * values[t.z];
}

glm::vec3 dielectric_f0(const Material& m) {
    const float r = (m.ior - 1) / (m.ior + 1);
    return m.specular * glm::min(r * r * m.specular_color, glm::vec3(1));
}

// Schlick's curve, averaged over the cosine-weighted hemisphere: the integral of (1 - x)^5 2 x dx is 1/21.
glm::vec3 mean_fresnel(const glm::vec3& f0, float f90) { return f0 + (f90 - f0) / 21.0f; }

// A mirror's Fresnel average stands for the specular lobe's.
glm::vec3 reflectance(const Material& m, const glm::vec3& base) {
    const glm::vec3 f0 = dielectric_f0(m);
    const glm::vec3 coat = mean_fresnel(f0, m.specular);
    const float lost = std::max({coat.x, coat.y, coat.z});
    const glm::vec3 dielectric = (1 - lost) * base + coat;
    return glm::mix(dielectric, mean_fresnel(base, 1), m.metallic);
}

} // namespace

std::vector<SurfaceMean> surface_means(const Scene& scene, std::span<const SceneElement> elements) {
    const TextureLookup lookup(scene);
    std::vector<SurfaceMean> means;
    means.reserve(elements.size());
    for (const SceneElement& element : elements) {
        const Mesh& mesh = scene.meshes[scene.instances[element.instance].mesh];
        const glm::uvec3& t = mesh.triangles[element.triangle];
        const Material& m = scene.materials[mesh.triangle_materials[element.triangle]];
        SurfaceMean mean{glm::vec3(0), glm::vec3(0), glm::vec3(0), 0};
        for (int i = 0; i < POINTS; ++i)
            for (int j = 0; j < POINTS; ++j) {
                const glm::vec2 at = point_on(element, i, j);
                const glm::vec2 uv0 = at_point(mesh.uv0, t, at, glm::vec2(0));
                const glm::vec2 uv1 = at_point(mesh.uv1, t, at, glm::vec2(0));
                const glm::vec4 vertex = at_point(mesh.colors, t, at, glm::vec4(1));
                const glm::vec4 texture = lookup.color(m.base_color_texture, uv0, uv1);
                const glm::vec4 base = glm::clamp(m.base_color * vertex * texture, 0.0f, 1.0f);
                mean.texture += glm::vec3(texture);
                mean.alpha += base.w;
                mean.reflectance += m.unlit ? glm::vec3(0) : reflectance(m, glm::vec3(base));
                mean.emission += m.unlit ? glm::vec3(base)
                                         : m.emission * glm::vec3(lookup.color(m.emission_texture, uv0, uv1));
            }
        constexpr float SHARE = 1.0f / (POINTS * POINTS);
        means.push_back(
            {mean.texture * SHARE, mean.reflectance * SHARE, mean.emission * SHARE, mean.alpha * SHARE});
    }
    return means;
}

std::vector<std::string> view_dependent_materials(const Scene& scene) {
    std::vector<bool> is_used(scene.materials.size());
    for (const Instance& instance : scene.instances)
        for (const std::uint32_t material : scene.meshes[instance.mesh].triangle_materials)
            is_used[material] = true;
    std::vector<std::string> names;
    for (std::size_t i = 0; i < scene.materials.size(); ++i) {
        const Material& m = scene.materials[i];
        const bool reflects = m.metallic != 0 || m.specular != 0;
        if (is_used[i] && !m.unlit && reflects)
            names.push_back(m.name.empty() ? "material " + std::to_string(i) : m.name);
    }
    return names;
}

} // namespace ajar
