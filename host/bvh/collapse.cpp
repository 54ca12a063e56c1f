// Optimal collapse of a binary tree: Ylitie, Karras and Laine 2017, "Efficient Incoherent Ray Traversal on
// GPUs Through Compressed Wide BVHs", section 3.
#include "bvh/collapse.hpp"

#include <tbb/parallel_invoke.h>

namespace ajar::bvh {
namespace {

constexpr std::uint32_t PARALLEL_SUBTREE = 4096;

} // namespace

Collapse::Collapse(const BinaryTree& tree, const BuildOptions& options)
    : tree_(tree), options_(options), root_area_(tree.nodes[0].box.half_area()), choices_(tree.nodes.size()) {
    options_.max_leaf_triangles = std::clamp(options.max_leaf_triangles, 1u, shared::BVH_MAX_LEAF);
    choose(0);
}

void Collapse::choose(std::uint32_t node_index) {
    const BinaryNode& node = tree_.nodes[node_index];
    Choice& choice = choices_[node_index];
    const float area = root_area_ > 0 ? float(node.box.half_area() / root_area_) : 0;
    const float leaf_cost = node.count <= options_.max_leaf_triangles
                                ? area * float(node.count) * options_.triangle_cost
                                : std::numeric_limits<float>::infinity();
    if (node.right == 0) {
        for (float& cost : choice.cost) cost = leaf_cost;
        choice.leaf = true;
        choice.node_cost = area + leaf_cost; // a hierarchy of one item
        return;
    }
    const std::uint32_t left = node_index + 1;
    if (node.count >= PARALLEL_SUBTREE) {
        tbb::parallel_invoke([&, this] { choose(left); }, [&, this] { choose(node.right); });
    } else {
        choose(left);
        choose(node.right);
    }
    distribute(choice, left, node.right);
    choice.node_cost += area;
    choice.leaf = leaf_cost <= choice.node_cost;
    choice.cost[0] = std::min(leaf_cost, choice.node_cost);
    for (std::uint32_t i = 2; i <= FOREST; ++i) {
        // Opening wins ties: it never deepens the tree.
        if (choice.cost[i - 1] <= choice.cost[i - 2]) continue;
        choice.cost[i - 1] = choice.cost[i - 2];
        choice.left[i] = 0;
    }
}

// For 2 to 8 roots, the best share of the left child; the cost for eight is what a wide node adds to its own.
void Collapse::distribute(Choice& choice, std::uint32_t left, std::uint32_t right) const {
    const Choice& l = choices_[left];
    const Choice& r = choices_[right];
    for (std::uint32_t i = 2; i <= shared::BVH_WIDTH; ++i) {
        float best = std::numeric_limits<float>::infinity();
        for (std::uint32_t k = 1; k < i; ++k) {
            const float cost = l.cost[k - 1] + r.cost[i - k - 1];
            if (cost < best || k == 1) best = cost, choice.left[i] = std::uint8_t(k);
        }
        if (i <= FOREST)
            choice.cost[i - 1] = best;
        else
            choice.node_cost = best;
    }
}

WideChildren Collapse::children(std::uint32_t node) const {
    WideChildren children;
    if (tree_.nodes[node].right == 0) {
        children[0] = {node, ChildKind::leaf};
        return children;
    }
    const std::uint32_t left = choices_[node].left[shared::BVH_WIDTH];
    WideChild* next = gather(node + 1, left, children.data());
    gather(tree_.nodes[node].right, shared::BVH_WIDTH - left, next);
    return children;
}

WideChild* Collapse::gather(std::uint32_t node, std::uint32_t roots, WideChild* out) const {
    const Choice& choice = choices_[node];
    while (roots > 1 && choice.left[roots] == 0) --roots;
    if (roots == 1 || tree_.nodes[node].right == 0) {
        *out = {node, choice.leaf ? ChildKind::leaf : ChildKind::inner};
        return out + 1;
    }
    out = gather(node + 1, choice.left[roots], out);
    return gather(tree_.nodes[node].right, roots - choice.left[roots], out);
}

} // namespace ajar::bvh
