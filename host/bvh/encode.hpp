// The third step of a build: the chosen tree as quantised nodes, and its items in leaf order.
#pragma once

#include "bvh/collapse.hpp"

namespace ajar::bvh {

// Fills nodes, order and stats.depth. Indices in the nodes begin at 0.
void encode(const BinaryTree& tree, const Collapse& collapse, Bvh& bvh);

// The box of a slot as a ray sees it, without its rounding margin; for tests and for boxes of placed meshes.
Box decode_slot(const shared::BvhNode& node, std::uint32_t slot);

} // namespace ajar::bvh
