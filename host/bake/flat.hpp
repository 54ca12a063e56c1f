// Triangles in a plane: whether they overlap, and the smallest rectangle around them.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <vector>

namespace ajar {

using FlatTriangle = std::array<glm::dvec2, 3>;

// False for triangles that cover a place which an earlier one that is true covers. Sharing edges, or reaching
// over one another by a rounding error, is no overlap.
std::vector<bool> without_overlap(const std::vector<FlatTriangle>& triangles);

// Turns and moves them, so that they lie within (0, 0) and the returned corner, whose x is at least its y, as
// small as it can be (one of its sides lies along their hull: Freeman and Shapira 1975).
glm::dvec2 lay_into_smallest_rectangle(std::vector<FlatTriangle>& triangles);

} // namespace ajar
