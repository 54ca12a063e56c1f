// How the light tree's nodes are quantised (shaders/shared/light_tree.glsl.h): conservatively, so that what a
// kernel decodes contains what was encoded.
#pragma once

#include "render/light_tree.hpp"

#include <array>
#include <span>

namespace ajar {

// A node's sphere as kernels decode it.
struct Sphere {
    glm::vec3 center{0};
    float radius = 0;
};

// `sphere`: the root's, for its children.
shared::LightTreeRoot encode_light_tree_root(const LightBounds& bounds, Sphere& sphere);

// Up to four children of a node whose own sphere is `parent`; all but the child words. `spheres`: theirs.
shared::LightTreeNode encode_light_tree_node(std::span<const LightBounds* const> children,
                                             const Sphere& parent, std::array<Sphere, 4>& spheres);

} // namespace ajar
