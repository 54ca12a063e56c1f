#include "render/light_tree_code.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace ajar {

using namespace shared;

namespace {

constexpr float ROUNDING = 1 + 1e-5f; // of float arithmetic here and in the kernels

Sphere sphere_of(const LightBounds& b) {
    return {0.5f * b.lower + 0.5f * b.upper, 0.5f * glm::length(b.upper - b.lower) * ROUNDING};
}

std::uint32_t snorm8(float x) {
    const int rounded = static_cast<int>(std::lround(x * static_cast<float>(LIGHT_TREE_SNORM)));
    return static_cast<std::uint32_t>(rounded) & 0xffu;
}

// Rounded down: a cone never gets narrower. A flat light's cosine, 1, is exact.
std::uint32_t cosine8(float x) {
    const float scaled = std::floor(std::clamp(x, -1.0f, 1.0f) * static_cast<float>(LIGHT_TREE_SNORM));
    return static_cast<std::uint32_t>(static_cast<int>(scaled)) & 0xffu;
}

std::uint32_t axis_word(const glm::vec3& axis) {
    return snorm8(axis.x) | snorm8(axis.y) << 8 | snorm8(axis.z) << 16;
}

// A float's upper bits as they are, the exponent counted from LIGHT_TREE_EXPONENT; 1 at least.
std::uint32_t intensity8(double share) {
    const double greatest = 1.875; // 255
    const auto bits = std::bit_cast<std::uint32_t>(static_cast<float>(share * greatest));
    const std::int32_t level = static_cast<std::int32_t>((bits + (1u << 19)) >> 20) -
                               static_cast<std::int32_t>(LIGHT_TREE_EXPONENT << 3);
    return static_cast<std::uint32_t>(std::clamp(level, 1, 255));
}

// As lights/light_tree.glsl decodes a coordinate.
float decoded(float parent, float radius, std::uint32_t step) {
    return parent + radius * (static_cast<float>(step) * (2.0f / LIGHT_TREE_PLACE_STEPS) - 1.0f);
}

std::uint32_t place_word(const glm::vec3& center, const Sphere& parent, glm::vec3& quantised) {
    std::uint32_t word = 0;
    for (int a = 0; a < 3; ++a) {
        const float along = parent.radius > 0 ? (center[a] - parent.center[a]) / parent.radius : 0;
        const float step = std::round(0.5f * (along + 1) * LIGHT_TREE_PLACE_STEPS);
        const auto code =
            static_cast<std::uint32_t>(std::clamp(step, 0.0f, static_cast<float>(LIGHT_TREE_PLACE_STEPS)));
        quantised[a] = decoded(parent.center[a], parent.radius, code);
        word |= code << (10 * a);
    }
    return word;
}

// The decoded radius is no less than `wanted`, which is the parent's at most but for the rounding of places.
std::uint32_t radius8(float wanted, float parent) {
    if (!(parent > 0)) return 0;
    const float root = std::sqrt(wanted / parent) * static_cast<float>(LIGHT_TREE_RADIUS_STEPS);
    return static_cast<std::uint32_t>(std::clamp(std::ceil(root), 1.0f, 255.0f));
}

} // namespace

LightTreeRoot encode_light_tree_root(const LightBounds& bounds, Sphere& sphere) {
    sphere = sphere_of(bounds);
    LightTreeRoot root{};
    root.center = sphere.center;
    root.radius = sphere.radius;
    root.axis = axis_word(bounds.axis);
    root.cones = cosine8(bounds.cos_normals) | cosine8(bounds.cos_emission) << 8;
    root.intensity = static_cast<float>(std::min(bounds.intensity, 1e30)); // sums and ratios stay finite
    root.flags = bounds.two_sided ? LIGHT_TREE_TWO_SIDED : 0u;
    return root;
}

LightTreeNode encode_light_tree_node(std::span<const LightBounds* const> children, const Sphere& parent,
                                     std::array<Sphere, 4>& spheres) {
    double brightest = 0;
    for (const LightBounds* b : children) brightest = std::max(brightest, b->intensity);
    LightTreeNode node{};
    for (std::size_t k = 0; k < children.size(); ++k) {
        const LightBounds& b = *children[k];
        const Sphere own = sphere_of(b);
        const auto byte = static_cast<std::uint32_t>(8 * k);
        node.place[k] =
            place_word(own.center, parent, spheres[k].center) | (b.two_sided ? LIGHT_TREE_TWO_SIDED : 0u);
        const float wanted = (own.radius + glm::length(own.center - spheres[k].center)) * ROUNDING;
        const std::uint32_t code = radius8(wanted, parent.radius);
        const float root = static_cast<float>(code) / LIGHT_TREE_RADIUS_STEPS;
        spheres[k].radius = parent.radius * root * root;
        node.axis[k] = axis_word(b.axis) | intensity8(b.intensity / brightest) << 24;
        node.radii |= code << byte;
        node.normals |= cosine8(b.cos_normals) << byte;
        node.emission |= cosine8(b.cos_emission) << byte;
    }
    return node;
}

} // namespace ajar
