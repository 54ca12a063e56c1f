// The second step of a build: which nodes of the binary tree become wide nodes and leaves.
#pragma once

#include "bvh/binary_tree.hpp"
#include "bvh/bvh.hpp"

#include <array>

namespace ajar::bvh {

enum class ChildKind : std::uint8_t { empty, inner, leaf };

// A slot of a wide node: the binary node that became a wide node or a leaf there.
struct WideChild {
    std::uint32_t node = 0;
    ChildKind kind = ChildKind::empty;
};
using WideChildren = std::array<WideChild, shared::BVH_WIDTH>;

// The cheapest wide tree within a binary one, by dynamic programming over SAH (Ylitie, Karras, Laine 2017,
// section 3): cost(n, i) is the least cost of the items of n as a forest of at most i wide nodes and leaves.
class Collapse {
  public:
    Collapse(const BinaryTree& tree, const BuildOptions& options);

    // Children of the wide node that binary node `node` becomes, in the order of the binary tree, then empty
    // ones.
    WideChildren children(std::uint32_t node) const;
    double sah_cost() const { return choices_[0].node_cost; }

  private:
    static constexpr std::uint32_t FOREST =
        shared::BVH_WIDTH - 1; // roots that one slot can at most be opened to

    struct Choice {
        float cost[FOREST];  // cost[i - 1] = cost(n, i), relative to the root's box
        float node_cost = 0; // as a wide node
        std::uint8_t left[shared::BVH_WIDTH + 1] =
            {};            // left[i]: of i roots those for the left child; 0: as left[i - 1]
        bool leaf = false; // as a single root: a leaf
    };

    void choose(std::uint32_t node);
    void distribute(Choice& choice, std::uint32_t left, std::uint32_t right) const;
    WideChild* gather(std::uint32_t node, std::uint32_t roots, WideChild* out) const; // returns the end

    const BinaryTree& tree_;
    BuildOptions options_;
    double root_area_ = 0;
    std::vector<Choice> choices_;
};

} // namespace ajar::bvh
