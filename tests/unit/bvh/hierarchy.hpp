// Walks a hierarchy as the kernels do, but in double, and checks every promise of bvh.glsl.h on the way.
#pragma once

#include "bvh/bvh.hpp"

#include <functional>
#include <string>

namespace ajar::test {

// Closed, in double: what float boxes and quantised ones are compared in.
struct Bounds {
    glm::dvec3 lower{INFINITY};
    glm::dvec3 upper{-INFINITY};
    void include(const glm::dvec3& point) { lower = glm::min(lower, point), upper = glm::max(upper, point); }
    void include(const Bounds& other) {
        lower = glm::min(lower, other.lower), upper = glm::max(upper, other.upper);
    }
    bool contains(const Bounds& other) const {
        return glm::all(glm::lessThanEqual(lower, other.lower)) &&
               glm::all(glm::greaterThanEqual(upper, other.upper));
    }
    double half_area() const {
        const glm::dvec3 d = upper - lower;
        return d.x * d.y + d.y * d.z + d.z * d.x;
    }
};

Bounds bounds_of(const bvh::Triangle& triangle);

// What a walk from `root` down met. `fault` is empty where nothing is wrong.
struct Walk {
    std::string fault;
    std::uint32_t depth = 0;              // nodes on the longest way
    std::uint32_t largest_leaf = 0;       // items
    double node_area = 0;                 // half areas of all nodes' contents, summed
    double item_area = 0;                 // half areas of the leaves' contents, each times its items
    double root_area = 0;                 // half area of everything
    std::vector<std::uint32_t> item_uses; // leaves that hold each item
};

// `bounds(i)`: what must lie in the slots above item i, for i in [first, first + count).
Walk walk(std::span<const shared::BvhNode> nodes, std::uint32_t root, std::uint32_t first,
          std::uint32_t count, const std::function<Bounds(std::uint32_t)>& bounds);

// A hierarchy over triangles, with `order` checked to name each of them once.
Walk walk(const bvh::Bvh& hierarchy, std::span<const bvh::Triangle> triangles);

} // namespace ajar::test
