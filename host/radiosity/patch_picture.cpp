#include "radiosity/patch_picture.hpp"

#include "radiosity/smooth_vertices.hpp"

namespace ajar {

PatchPicture patch_picture(const RadiositySolution& solution) {
    const SmoothVertices smooth(solution.mesh);
    const std::vector<glm::vec3> irradiance =
        smooth.mean(solution.mesh, solution.irradiance, solution.active);
    PatchPicture picture{solution.mesh.triangles(), solution.mesh.nodes, {}};
    picture.sides.resize(solution.radiance.size());
    for (std::uint32_t side = 0; side < picture.sides.size(); ++side) {
        picture.sides[side].radiance = solution.radiance[side];
        for (std::uint32_t k = 0; k < 3; ++k)
            picture.sides[side].irradiance[k] = irradiance[smooth.vertex(side, k)];
    }
    return picture;
}

} // namespace ajar
