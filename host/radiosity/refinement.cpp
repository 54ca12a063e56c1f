#include "radiosity/refinement.hpp"

#include "radiosity/smooth_vertices.hpp"
#include "render/luminance.hpp"

#include <algorithm>
#include <glm/gtc/constants.hpp>

namespace ajar {

std::vector<std::uint8_t> mark_gradients(const RadiositySolution& solution, float threshold) {
    const PatchMesh& mesh = solution.mesh;
    const SmoothVertices vertices(mesh);
    const std::vector<glm::vec3> corners = vertices.mean(mesh, solution.irradiance, solution.active);
    const auto reflected = [&](std::uint32_t side, const glm::vec3& irradiance) {
        return luminance(glm::dvec3(solution.reflectance[side] * irradiance)) / glm::pi<double>();
    };
    double power = 0;
    double area = 0;
    for (std::uint32_t side = 0; side < solution.active.size(); ++side) {
        if (solution.active[side] == 0) continue;
        area += mesh.patches[side / 2].area;
        power += mesh.patches[side / 2].area * reflected(side, solution.irradiance[side]);
    }
    std::vector<std::uint8_t> marked(mesh.patches.size());
    for (std::uint32_t side = 0; side < solution.active.size() && area > 0; ++side) {
        if (solution.active[side] == 0) continue;
        double values[3];
        for (std::uint32_t k = 0; k < 3; ++k) values[k] = reflected(side, corners[vertices.vertex(side, k)]);
        const auto [least, greatest] = std::minmax_element(values, values + 3);
        if (*greatest - *least > threshold * power / area) marked[side / 2] = 1;
    }
    return marked;
}

} // namespace ajar
