#include "render/emissive_triangles.hpp"

#include "render/emission_means.hpp"

#include <array>
#include <glm/glm.hpp>

namespace ajar {

namespace {

// Of the set that the emission texture uses; the order of a mirrored triangle does not matter to its mean.
std::array<glm::vec2, 3> texture_coordinates(const Scene& scene, const TriangleSource& source,
                                             const Material& material) {
    const Mesh& mesh = scene.meshes[scene.instances[source.instance].mesh];
    const std::vector<glm::vec2>& uv = material.emission_texture.uv_set == 1 ? mesh.uv1 : mesh.uv0;
    std::array<glm::vec2, 3> corners{};
    if (uv.empty()) return corners;
    for (int k = 0; k < 3; ++k) corners[static_cast<std::size_t>(k)] = uv[mesh.triangles[source.triangle][k]];
    return corners;
}

} // namespace

std::vector<EmissiveSphere> collect_emissive_spheres(const Scene& scene) {
    std::vector<EmissiveSphere> spheres;
    for (std::uint32_t i = 0; i < scene.instances.size() && spheres.size() < shared::MAX_SOFT_LIGHTS; ++i) {
        const Instance& instance = scene.instances[i];
        const std::vector<std::uint32_t>& materials = scene.meshes[instance.mesh].triangle_materials;
        if (!(instance.sphere_radius > 0) || materials.empty()) continue;
        const Material& material = scene.materials[materials[0]];
        if (material.unlit || material.emission == glm::vec3(0)) continue;
        spheres.push_back({i, instance.sphere_center, instance.sphere_radius, material.emission});
    }
    return spheres;
}

std::vector<EmissiveTriangle> collect_emissive_triangles(const Scene& scene, const GeometryTable& geometry,
                                                         std::span<const EmissiveSphere> spheres) {
    EmissionMeans means(scene);
    std::vector<bool> is_sphere(scene.instances.size());
    for (const EmissiveSphere& sphere : spheres) is_sphere[sphere.instance] = true;
    std::vector<EmissiveTriangle> emitters;
    for (std::uint32_t k = 0; k < geometry.world_triangles; ++k) {
        const shared::TriangleRecord& t = geometry.triangles[k];
        const Material& material = scene.materials[t.material];
        if (is_sphere[geometry.sources[k].instance]) continue;
        if (material.unlit || material.emission == glm::vec3(0)) continue;
        EmissiveTriangle e;
        e.p0 = bvh::record_vertex(t, 0);
        e.p1 = bvh::record_vertex(t, 1);
        e.p2 = bvh::record_vertex(t, 2);
        e.area = 0.5f * glm::length(glm::cross(e.p1 - e.p0, e.p2 - e.p0));
        if (!(e.area > 0)) continue;
        e.triangle = k;
        e.material = t.material;
        e.emission = means.mean(t.material, texture_coordinates(scene, geometry.sources[k], material));
        if (e.emission == glm::vec3(0)) continue;
        e.two_sided = material.double_sided;
        e.textured = material.emission_texture.used() || material.alpha_mode != AlphaMode::opaque;
        emitters.push_back(e);
    }
    return emitters;
}

} // namespace ajar
