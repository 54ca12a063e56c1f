// Which child sits in which slot of a wide node, so that slot ^ octant of a direction goes roughly front to
// back.
#pragma once

#include "bvh/collapse.hpp"

namespace ajar::bvh {

// The same children, each in its slot. Bit a of a slot set: towards the upper end of axis a.
WideChildren arrange(const BinaryTree& tree, std::uint32_t node, const WideChildren& children);

} // namespace ajar::bvh
