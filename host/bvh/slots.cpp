// Slot assignment: Ylitie, Karras and Laine 2017, section 3.2 (here greedy, then improved by exchanges,
// instead of the auction: within a percent of it and simpler).
#include "bvh/slots.hpp"

namespace ajar::bvh {
namespace {

constexpr std::uint32_t WIDTH = shared::BVH_WIDTH;

// How far child c lies towards the corner that slot s stands for.
using Gains = std::array<std::array<float, WIDTH>, WIDTH>;

Gains measure_gains(const BinaryTree& tree, std::uint32_t node, const WideChildren& children) {
    const Box& box = tree.nodes[node].box;
    // Relative to the box, as only comparisons matter and coordinates may be huge.
    const float extent = std::max({box.upper[0] - box.lower[0], box.upper[1] - box.lower[1],
                                   box.upper[2] - box.lower[2], std::numeric_limits<float>::min()});
    Gains gains{};
    for (std::uint32_t c = 0; c < WIDTH && children[c].kind != ChildKind::empty; ++c) {
        const Box& child = tree.nodes[children[c].node].box;
        for (std::uint32_t s = 0; s < WIDTH; ++s) {
            for (int axis = 0; axis < 3; ++axis) {
                const float lower = (child.lower[axis] - box.lower[axis]) / extent;
                const float upper = (child.upper[axis] - box.upper[axis]) / extent;
                gains[c][s] += s >> axis & 1 ? lower + upper : -(lower + upper);
            }
        }
    }
    return gains;
}

using Assignment = std::array<std::uint32_t, WIDTH>; // slot of each child; empty children count too

Assignment assign_greedily(const Gains& gains) {
    Assignment slots{};
    std::uint32_t free_children = (1u << WIDTH) - 1;
    std::uint32_t free_slots = free_children;
    while (free_children != 0) {
        float best = -INFINITY;
        std::uint32_t child = 0;
        std::uint32_t slot = 0;
        for (std::uint32_t c = 0; c < WIDTH; ++c) {
            for (std::uint32_t s = 0; s < WIDTH; ++s) {
                const bool free = (free_children >> c & 1) != 0 && (free_slots >> s & 1) != 0;
                // An empty child has no gain anywhere: it takes what the others leave.
                if (free && (gains[c][s] > best || best == -INFINITY))
                    best = gains[c][s], child = c, slot = s;
            }
        }
        slots[child] = slot;
        free_children &= ~(1u << child);
        free_slots &= ~(1u << slot);
    }
    return slots;
}

void improve_by_exchange(const Gains& gains, Assignment& slots) {
    bool better = true;
    for (int round = 0; better && round < 8; ++round) {
        better = false;
        for (std::uint32_t a = 0; a < WIDTH; ++a) {
            for (std::uint32_t b = a + 1; b < WIDTH; ++b) {
                const float now = gains[a][slots[a]] + gains[b][slots[b]];
                if (gains[a][slots[b]] + gains[b][slots[a]] <= now) continue;
                std::swap(slots[a], slots[b]);
                better = true;
            }
        }
    }
}

} // namespace

WideChildren arrange(const BinaryTree& tree, std::uint32_t node, const WideChildren& children) {
    const Gains gains = measure_gains(tree, node, children);
    Assignment slots = assign_greedily(gains);
    improve_by_exchange(gains, slots);
    WideChildren arranged;
    for (std::uint32_t c = 0; c < WIDTH; ++c) arranged[slots[c]] = children[c];
    return arranged;
}

} // namespace ajar::bvh
