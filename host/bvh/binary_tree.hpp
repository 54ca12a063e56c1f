// The first step of a build: a binary tree down to single items, by binned SAH (Wald 2007).
#pragma once

#include "bvh/box.hpp"

#include <span>
#include <vector>

namespace ajar::bvh {

// A node over items [first, first + count) of BinaryTree::order. The left child of node i is i + 1, the right
// one is i + 2 * (items on the left): a place that depends on nothing but the splits, so threads need not
// agree on any.
struct BinaryNode {
    Box box;
    std::uint32_t first = 0;
    std::uint32_t count = 0;
    std::uint32_t right = 0; // 0: a leaf
};

struct BinaryTree {
    std::vector<BinaryNode> nodes; // 2 n - 1
    std::vector<std::uint32_t> order;
};

enum class SplitRule { surface_area, median };

// At least one box. `median` halves the items by number, which bounds the depth; it serves inputs that drive
// SAH too deep.
BinaryTree build_binary_tree(std::span<const Box> boxes, SplitRule rule);

} // namespace ajar::bvh
