// A light tree: which lights can bring how much to a point, coarse to fine (Conty Estevez and Kulla 2018),
// four children to a node (shaders/shared/light_tree.glsl.h).
#pragma once

#include "shaders/shared/light_tree.glsl.h"

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace ajar {

// A light, or all lights below a node, as the tree sees them.
struct LightBounds {
    glm::vec3 lower{0}; // box, world, metres
    glm::vec3 upper{0};
    glm::vec3 axis{0, 0, 1}; // of the cone of normals, unit
    float cos_normals = 1;   // half angle of that cone: 1 for a flat light, -1 for a point
    float cos_emission = 0;  // greatest angle between a normal and light that leaves: 0 where Lambertian
    bool two_sided = false;
    double intensity = 0; // greatest of any direction, luminance, W/sr; 0: the light is left out
};

struct LightTree {
    bool empty = true; // no light is left: everything else is empty, too
    shared::LightTreeRoot root{};
    std::vector<shared::LightTreeNode> nodes; // see light_tree.glsl.h
    std::vector<std::uint32_t> trails;        // per light
    std::uint32_t depth = 0;                  // decisions on the longest way
    double seconds = 0;                       // of building
};

// Deterministic for any number of threads. Throws Error for more than 2^24 lights.
LightTree build_light_tree(std::span<const LightBounds> lights);

// The smallest such bounds around both that the tree's arithmetic knows.
LightBounds merge(const LightBounds& a, const LightBounds& b);

} // namespace ajar
