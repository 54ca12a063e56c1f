// Values of patches' sides as values at corners, for shading that varies linearly across a patch: at a
// vertex, the area-weighted mean over the sides around it that belong to one smooth surface. It keeps the
// integral: the mean of a linear function over a patch is that of its corners.
#pragma once

#include "radiosity/patch_mesh.hpp"

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace ajar {

class SmoothVertices {
  public:
    // Sides that share an edge belong together where their normals are within that angle, in radians.
    explicit SmoothVertices(const PatchMesh& mesh, float crease_angle = 0.25f * 3.14159265f);

    // Of a side's corner (0, 1, 2, as in Patch::vertices, on either side).
    std::uint32_t vertex(std::uint32_t side, std::uint32_t corner) const {
        return vertices_[3 * std::size_t{side} + corner];
    }
    std::uint32_t count() const { return static_cast<std::uint32_t>(positions_.size()); }
    // PatchMesh::positions, by smooth vertex.
    const std::vector<std::uint32_t>& positions() const { return positions_; }

    // By smooth vertex, of values by side. Sides that are not active do not count (nobody sees them, and what
    // they hold means nothing); 0 where no side does.
    std::vector<glm::vec3> mean(const PatchMesh& mesh, std::span<const glm::vec3> by_side,
                                std::span<const std::uint8_t> active) const;

  private:
    std::vector<std::uint32_t> vertices_;  // by 3 * side + corner
    std::vector<std::uint32_t> positions_; // by smooth vertex
};

} // namespace ajar
