// The scene's surfaces cut into charts: pieces that lie flat in a plane without folds or overlap.
#pragma once

#include "scene/scene.hpp"

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace ajar {

// Corners in the order of the mesh, in double, as areas and angles of small triangles far out need it.
struct PlacedTriangle {
    std::uint32_t instance = 0;          // Scene::instances
    std::uint32_t triangle = 0;          // of its mesh
    std::array<glm::dvec3, 3> corners{}; // world, metres
};

// Those of all instances, in order, without those that have no area.
std::vector<PlacedTriangle> placed_triangles(const Scene& scene);

struct Chart {
    std::vector<std::uint32_t> triangles; // indices of placed triangles
    glm::dvec2 extent{0, 0};              // metres, the first is the larger one
};

struct Charts {
    std::vector<PlacedTriangle> triangles;
    std::vector<Chart> charts;
    std::vector<std::uint32_t> chart_of; // by triangle
    std::vector<std::array<glm::dvec2, 3>>
        flat_corners; // by triangle: within its chart, from (0, 0) to extent
};

// A triangle turned away from its chart's plane is foreshortened by the cosine, so texels are stretched by up
// to the square root of two.
inline constexpr double CHART_ANGLE = 0.78539816339744831; // radians, 45 degrees

Charts make_charts(std::vector<PlacedTriangle> triangles);

} // namespace ajar
