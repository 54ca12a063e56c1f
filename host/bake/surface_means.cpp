#include "bake/surface_means.hpp"

#include "bake/texture_lookup.hpp"

#include <algorithm>

namespace ajar {

namespace {

constexpr int POINTS = 4; // a side of the grid on each piece

template <class T>
T at_point(const std::vector<T>& values, const glm::uvec3& t, const glm::vec2& at, const T& none) {
    if (values.empty()) return none;
    return (1 - at.x - at.y) * values[t.x] + at.x * values[t.y] + at.y * values[t.z];
}

} // namespace

glm::vec2 point_on(const SceneElement& element, glm::vec2 w) {
    if ((element.flags & shared::ELEMENT_QUAD) == 0 && w.x + w.y > 1)
        w = 1.0f - w; // folded into the triangle
    const glm::vec2 at = glm::max(element.origin + w.x * element.edge_a + w.y * element.edge_b, 0.0f);
    return at.x + at.y > 1 ? at / (at.x + at.y) : at;
}

std::vector<TextureMean> texture_means(const Scene& scene, std::span<const SceneElement> elements) {
    const TextureLookup lookup(scene);
    std::vector<TextureMean> means;
    means.reserve(elements.size());
    for (const SceneElement& element : elements) {
        const Mesh& mesh = scene.meshes[scene.instances[element.instance].mesh];
        const glm::uvec3& t = mesh.triangles[element.triangle];
        const Material& m = scene.materials[mesh.triangle_materials[element.triangle]];
        TextureMean mean{glm::vec3(0), 0};
        for (int i = 0; i < POINTS; ++i)
            for (int j = 0; j < POINTS; ++j) {
                const glm::vec2 at = point_on(element, (glm::vec2(i, j) + 0.5f) / static_cast<float>(POINTS));
                const glm::vec2 uv0 = at_point(mesh.uv0, t, at, glm::vec2(0));
                const glm::vec2 uv1 = at_point(mesh.uv1, t, at, glm::vec2(0));
                const glm::vec4 texture = lookup.color(m.base_color_texture, uv0, uv1);
                const float vertex = at_point(mesh.colors, t, at, glm::vec4(1)).w;
                mean.color += glm::vec3(texture);
                mean.alpha += std::clamp(m.base_color.w * vertex * texture.w, 0.0f, 1.0f);
            }
        constexpr float SHARE = 1.0f / (POINTS * POINTS);
        means.push_back({mean.color * SHARE, mean.alpha * SHARE});
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
