#include "bake/patch_light.hpp"

#include "radiosity/smooth_vertices.hpp"

#include <algorithm>
#include <utility>

namespace ajar {

RadiositySolution solve_for_bake(const gpu::Device& device, const Scene& scene, const BakeSettings& settings,
                                 const ProgressSink& progress, const WarningSink& warn) {
    RadiositySettings radiosity;
    radiosity.patches = {settings.patch_size, settings.patches};
    radiosity.shadow_samples = settings.render.samples;
    radiosity.render = settings.render;
    return solve_radiosity(device, scene, radiosity, progress, warn);
}

std::vector<glm::vec3> front_irradiance(const RadiositySolution& solution) {
    std::vector<glm::vec3> fronts;
    fronts.reserve(solution.mesh.patches.size());
    for (std::size_t p = 0; p < solution.mesh.patches.size(); ++p)
        fronts.push_back(solution.irradiance[2 * p + shared::PATCH_FRONT]);
    return fronts;
}

ElementMaterials front_materials(const RadiositySolution& solution) {
    ElementMaterials fronts;
    for (std::size_t p = 0; p < solution.mesh.patches.size(); ++p) {
        fronts.emission.push_back(solution.emission[2 * p + shared::PATCH_FRONT]);
        fronts.reflectance.push_back(solution.reflectance[2 * p + shared::PATCH_FRONT]);
    }
    return fronts;
}

std::vector<glm::vec3> irradiance_at(const Scene& scene, const RadiositySolution& solution,
                                     std::span<const SceneElement> elements) {
    const PatchMesh& mesh = solution.mesh;
    const SmoothVertices smooth(mesh);
    const std::vector<glm::vec3> at_vertices = smooth.mean(mesh, solution.irradiance, solution.active);
    std::vector<glm::vec3> result;
    result.reserve(elements.size());
    for (const SceneElement& element : elements) {
        const std::pair wanted(element.instance, element.triangle);
        const auto source = std::lower_bound( // in the order of instances and triangles
            mesh.sources.begin(), mesh.sources.end(), wanted,
            [](const PatchSource& s, const auto& key) { return std::pair(s.instance, s.triangle) < key; });
        if (source == mesh.sources.end() || std::pair(source->instance, source->triangle) != wanted) {
            result.emplace_back(0); // so small that as a float it has no area
            continue;
        }
        glm::vec2 at = point_on(element, glm::vec2(0.5f));
        if (mirrors(scene.instances[element.instance].to_world)) std::swap(at.x, at.y);
        const auto number = static_cast<std::uint32_t>(source - mesh.sources.begin());
        const PatchPoint point = mesh.find(number, at.x, at.y);
        const auto corner = [&](std::uint32_t k) {
            return at_vertices[smooth.vertex(2 * point.patch + shared::PATCH_FRONT, k)];
        };
        result.push_back((1 - point.u - point.v) * corner(0) + point.u * corner(1) + point.v * corner(2));
    }
    return result;
}

} // namespace ajar
