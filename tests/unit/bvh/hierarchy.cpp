// Decodes wide nodes by what bvh.glsl.h says of them alone: nothing of the encoder is used here.
#include "unit/bvh/hierarchy.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace ajar::test {
namespace {

using shared::BvhNode;

// A slot's box, shrunk by the margin that the slab test's rounding may use up.
Bounds slot_box(const BvhNode& node, std::uint32_t slot) {
    constexpr double SPENT_BY_ROUNDING = 1.0 / 4096; // steps of the node's grid
    const std::uint32_t* lower[3] = {node.lower_x, node.lower_y, node.lower_z};
    const std::uint32_t* upper[3] = {node.upper_x, node.upper_y, node.upper_z};
    Bounds box;
    for (int axis = 0; axis < 3; ++axis) {
        const double step = std::ldexp(1.0, int(node.exponents >> (8 * axis) & 0xff) - 127);
        const auto byte = [&](const std::uint32_t* words) {
            return words[slot / 4] >> (slot % 4 * 8) & 0xff;
        };
        box.lower[axis] = node.origin[axis] + step * (byte(lower[axis]) + SPENT_BY_ROUNDING);
        box.upper[axis] = node.origin[axis] + step * (byte(upper[axis]) - SPENT_BY_ROUNDING);
    }
    return box;
}

class Walker {
  public:
    Walker(std::span<const BvhNode> nodes, std::uint32_t first, std::uint32_t count,
           const std::function<Bounds(std::uint32_t)>& bounds)
        : nodes_(nodes), first_(first), bounds_(bounds), visited_(nodes.size()) {
        result_.item_uses.resize(count);
    }

    Walk run(std::uint32_t root) {
        const Bounds all = node(root, 1);
        result_.root_area = result_.item_uses.empty() ? 0 : all.half_area();
        return std::move(result_);
    }

  private:
    void complain(std::uint32_t index, std::uint32_t slot, const char* what) {
        if (result_.fault.empty())
            result_.fault = "node " + std::to_string(index) + " slot " + std::to_string(slot) + ": " + what;
    }

    Bounds node(std::uint32_t index, std::uint32_t depth) {
        Bounds contents;
        if (index >= nodes_.size()) return complain(index, 0, "does not exist"), contents;
        if (visited_[index]) return complain(index, 0, "has two parents"), contents;
        visited_[index] = true;
        result_.depth = std::max(result_.depth, depth);
        const BvhNode& n = nodes_[index];
        std::uint32_t item = n.triangle_base;
        for (std::uint32_t slot = 0; slot < shared::BVH_WIDTH; ++slot) {
            const std::uint32_t leaf = n.leaves >> (shared::BVH_MAX_LEAF * slot) & 7;
            const bool inner = (n.inner_orders >> slot & 1) != 0;
            check_orders(index, slot, inner);
            if (inner && leaf != 0) complain(index, slot, "is an inner child and a leaf");
            if (!inner && leaf == 0) continue;
            const Bounds below =
                inner ? node((n.child_base >> 8) + slot, depth + 1) : take_leaf(index, slot, leaf, item);
            if (!slot_box(n, slot).contains(below)) complain(index, slot, "does not hold what is below it");
            contents.include(below);
        }
        if (n.leaves >> (shared::BVH_MAX_LEAF * shared::BVH_WIDTH) != 0)
            complain(index, 8, "has leaf bits beyond the last slot");
        if ((n.child_base & 0xff) != 0) complain(index, 0, "child_base is not a multiple of 256");
        if (n.inner_orders != 0 || n.leaves != 0) result_.node_area += contents.half_area();
        return contents;
    }

    void check_orders(std::uint32_t index, std::uint32_t slot, bool inner) {
        for (std::uint32_t k = 1; k < 4; ++k)
            if ((nodes_[index].inner_orders >> (8 * k + (slot ^ k)) & 1) != std::uint32_t(inner))
                complain(index, slot, "stands in one order of inner_orders and not in another");
    }

    // Moves `item` past the leaf's items.
    Bounds take_leaf(std::uint32_t index, std::uint32_t slot, std::uint32_t bits, std::uint32_t& item) {
        Bounds contents;
        const auto count = std::uint32_t(std::popcount(bits));
        if (bits + 1 != 1u << count) complain(index, slot, "leaf bits with a gap");
        result_.largest_leaf = std::max(result_.largest_leaf, count);
        for (std::uint32_t k = 0; k < count; ++k, ++item) {
            if (item < first_ || item - first_ >= result_.item_uses.size())
                return complain(index, slot, "names an item that does not exist"), contents;
            ++result_.item_uses[item - first_];
            contents.include(bounds_(item));
        }
        result_.item_area += contents.half_area() * count;
        return contents;
    }

    std::span<const BvhNode> nodes_;
    std::uint32_t first_;
    const std::function<Bounds(std::uint32_t)>& bounds_;
    std::vector<bool> visited_;
    Walk result_;
};

} // namespace

Bounds bounds_of(const bvh::Triangle& triangle) {
    Bounds bounds;
    for (const glm::vec3& vertex : triangle.vertices) bounds.include(glm::dvec3(vertex));
    return bounds;
}

Walk walk(std::span<const BvhNode> nodes, std::uint32_t root, std::uint32_t first, std::uint32_t count,
          const std::function<Bounds(std::uint32_t)>& bounds) {
    Walk result = Walker(nodes, first, count, bounds).run(root);
    const bool once = std::all_of(result.item_uses.begin(), result.item_uses.end(),
                                  [](std::uint32_t uses) { return uses == 1; });
    if (result.fault.empty() && !once) result.fault = "an item lies in no leaf, or in two";
    return result;
}

Walk walk(const bvh::Bvh& hierarchy, std::span<const bvh::Triangle> triangles) {
    std::vector<std::uint32_t> sorted = hierarchy.order;
    std::sort(sorted.begin(), sorted.end());
    bool permutation = sorted.size() == triangles.size();
    for (std::uint32_t i = 0; permutation && i < sorted.size(); ++i) permutation = sorted[i] == i;
    Walk wrong;
    wrong.fault = "order is no permutation of the triangles";
    if (!permutation) return wrong;
    return walk(hierarchy.nodes, 0, 0, std::uint32_t(triangles.size()),
                [&](std::uint32_t item) { return bounds_of(triangles[hierarchy.order[item]]); });
}

} // namespace ajar::test
