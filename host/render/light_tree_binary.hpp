// The binary tree over lights that the wide one is made of. Splits minimise intensity times orientation times
// extent (Conty Estevez and Kulla 2018, equation 2), found by binning.
#pragma once

#include "render/light_tree.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace ajar {

constexpr std::uint32_t BINARY_LEAF = 1u << 31;

// Siblings lie side by side.
struct BinaryNode {
    LightBounds bounds;
    std::uint32_t child = 0;  // a light's index with BINARY_LEAF, or the first child's
    std::uint32_t height = 0; // decisions below

    bool is_light() const { return (child & BINARY_LEAF) != 0; }
    std::uint32_t light() const { return child & ~BINARY_LEAF; }
    // What is gained by telling its children apart: nothing for a light.
    double reach() const {
        const glm::vec3 extent = bounds.upper - bounds.lower;
        return is_light() ? -1 : bounds.intensity * glm::dot(extent, extent);
    }
};

// Over the lights of some intensity, at least one. Node 0 is the root; node 1 is nothing. Deterministic for
// any number of threads. No way is longer than two bits of a trail for each of its decisions allow.
std::vector<BinaryNode> build_binary_light_tree(std::span<const LightBounds> lights);

} // namespace ajar
