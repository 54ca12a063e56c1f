#include "radiosity/smooth_vertices.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>

namespace ajar {

using namespace shared;

namespace {

constexpr std::uint32_t NONE = 0xffffffffu;

// The corners (3 * patch + place) at each vertex: those of vertex v are corners[first[v]] up to first[v + 1].
struct Fans {
    std::vector<std::uint32_t> first;
    std::vector<std::uint32_t> corners;
};

Fans collect_fans(const PatchMesh& mesh) {
    Fans fans;
    fans.first.resize(mesh.positions.size() + 1);
    fans.corners.resize(3 * mesh.patches.size());
    for (const Patch& patch : mesh.patches)
        for (const std::uint32_t v : patch.vertices) ++fans.first[v + 1];
    std::partial_sum(fans.first.begin(), fans.first.end(), fans.first.begin());
    std::vector<std::uint32_t> next(fans.first.begin(), fans.first.end() - 1);
    for (std::uint32_t p = 0; p < mesh.patches.size(); ++p)
        for (std::uint32_t k = 0; k < 3; ++k) fans.corners[next[mesh.patches[p].vertices[k]]++] = 3 * p + k;
    return fans;
}

// The sides around one vertex in groups, by union-find: side 2 i + s is that of the fan's corner i.
class Fan {
  public:
    Fan(const PatchMesh& mesh, std::span<const std::uint32_t> corners, float crease_cos)
        : parents_(2 * corners.size()) {
        std::iota(parents_.begin(), parents_.end(), 0u);
        for (std::uint32_t i = 0; i < corners.size(); ++i) {
            const Patch& patch = mesh.patches[corners[i] / 3];
            for (const std::uint32_t step : {1u, 2u})
                spokes_.push_back({patch.vertices[(corners[i] + step) % 3], i});
        }
        std::sort(spokes_.begin(), spokes_.end());
        for (std::size_t a = 0; a < spokes_.size(); ++a)
            for (std::size_t b = a + 1; b < spokes_.size() && spokes_[b].first == spokes_[a].first; ++b)
                join(mesh, corners, spokes_[a].second, spokes_[b].second, crease_cos);
    }

    std::uint32_t root(std::uint32_t side) const {
        while (parents_[side] != side) side = parents_[side];
        return side;
    }

  private:
    void join(const PatchMesh& mesh, std::span<const std::uint32_t> corners, std::uint32_t i, std::uint32_t j,
              float crease_cos) {
        const float cosine =
            glm::dot(mesh.patches[corners[i] / 3].normal, mesh.patches[corners[j] / 3].normal);
        if (std::abs(cosine) < crease_cos) return;
        const std::uint32_t turned = cosine < 0 ? 1 : 0; // the front of one continues the back of the other
        for (const std::uint32_t side : {PATCH_FRONT, PATCH_BACK}) {
            const std::uint32_t a = root(2 * i + side);
            const std::uint32_t b = root(2 * j + (side ^ turned));
            parents_[std::max(a, b)] = std::min(a, b);
        }
    }

    std::vector<std::uint32_t> parents_;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> spokes_; // an edge's other vertex, the fan's corner
};

} // namespace

SmoothVertices::SmoothVertices(const PatchMesh& mesh, float crease_angle)
    : vertices_(6 * mesh.patches.size(), NONE) {
    const Fans fans = collect_fans(mesh);
    const float crease_cos = std::cos(crease_angle);
    for (std::uint32_t v = 0; v < mesh.positions.size(); ++v) {
        const std::span<const std::uint32_t> corners(&fans.corners[fans.first[v]],
                                                     fans.first[v + 1] - fans.first[v]);
        const Fan fan(mesh, corners, crease_cos);
        std::vector<std::uint32_t> smooth(2 * corners.size(), NONE); // by root
        for (std::uint32_t i = 0; i < corners.size(); ++i)
            for (const std::uint32_t side : {PATCH_FRONT, PATCH_BACK}) {
                std::uint32_t& vertex = smooth[fan.root(2 * i + side)];
                if (vertex == NONE) {
                    vertex = count();
                    positions_.push_back(v);
                }
                vertices_[3 * (2 * (corners[i] / 3) + side) + corners[i] % 3] = vertex;
            }
    }
}

std::vector<glm::vec3> SmoothVertices::mean(const PatchMesh& mesh, std::span<const glm::vec3> by_side,
                                            std::span<const std::uint8_t> active) const {
    assert(3 * by_side.size() == vertices_.size() && active.size() == by_side.size());
    std::vector<glm::dvec4> sums(count()); // value times area, area
    for (std::size_t side = 0; side < by_side.size(); ++side) {
        if (active[side] == 0) continue;
        const double area = mesh.patches[side / 2].area;
        for (std::size_t k = 0; k < 3; ++k)
            sums[vertices_[3 * side + k]] += area * glm::dvec4(glm::dvec3(by_side[side]), 1);
    }
    std::vector<glm::vec3> means(count());
    for (std::size_t v = 0; v < means.size(); ++v)
        if (sums[v].w > 0) means[v] = glm::vec3(glm::dvec3(sums[v]) / sums[v].w);
    return means;
}

} // namespace ajar
