// Quantised wide nodes: Ylitie, Karras and Laine 2017, sections 2 and 3.
#include "bvh/encode.hpp"

#include "bvh/slots.hpp"

#include <atomic>
#include <bit>
#include <numeric>
#include <tbb/parallel_for.h>

namespace ajar::bvh {
namespace {

constexpr std::uint32_t PARALLEL_SUBTREE = 4096;

// In steps of the node's grid. The slab test computes (origin - o) / d + q * step / d with a few roundings,
// each at most 2^-24 of the node's extent (256 steps): in all less than 2^-12 of a step. Errors in proportion
// to the distance are the slab test's own business.
constexpr double MARGIN = 1.0 / 256;

struct Grid {
    float origin;
    int exponent; // of a step
    double place(float x) const { return std::ldexp(double(x) - origin, -exponent); }
};

// The finest grid of 256 lines that holds [lower, upper] with a margin on both sides.
Grid fit_grid(float lower, float upper) {
    const double extent = double(upper) - lower;
    int exponent = extent > 0 ? std::max(std::ilogb(extent / 255), -126) : -126;
    for (;; ++exponent) {
        const double wanted = double(lower) - MARGIN * std::ldexp(1.0, exponent);
        float origin = float(wanted);
        if (origin > wanted) origin = std::nextafter(origin, -INFINITY);
        origin = std::max(origin, -std::numeric_limits<float>::max());
        const Grid grid{origin, exponent};
        if (std::ceil(grid.place(upper) + MARGIN) <= 255) return grid;
    }
}

void put_byte(std::uint32_t* words, std::uint32_t slot, double value) {
    const auto byte = std::uint32_t(std::clamp(value, 0.0, 255.0));
    words[slot / 4] = (words[slot / 4] & ~(0xffu << (slot % 4 * 8))) | byte << (slot % 4 * 8);
}

std::uint32_t bits_of(const WideChildren& children, ChildKind kind) {
    std::uint32_t bits = 0;
    for (std::uint32_t slot = 0; slot < shared::BVH_WIDTH; ++slot)
        bits |= std::uint32_t(children[slot].kind == kind) << slot;
    return bits;
}

class Encoder {
  public:
    Encoder(const BinaryTree& tree, const Collapse& collapse, Bvh& bvh)
        : tree_(tree), collapse_(collapse), bvh_(bvh), below_(tree.nodes.size()) {}

    void run() {
        bvh_.nodes.resize(1 + count_below(0, 1));
        bvh_.order.resize(tree_.order.size());
        write(0, 0, 1, 0);
        bvh_.stats.depth = depth_;
    }

  private:
    // Calls f(slot) for each inner child, in parallel where `items` below them are many.
    template <class F> static void each_inner(const WideChildren& children, std::uint32_t items, const F& f) {
        const auto visit = [&](std::uint32_t slot) {
            if (children[slot].kind == ChildKind::inner) f(slot);
        };
        if (items >= PARALLEL_SUBTREE) {
            tbb::parallel_for(0u, shared::BVH_WIDTH, visit);
        } else {
            for (std::uint32_t slot = 0; slot < shared::BVH_WIDTH; ++slot) visit(slot);
        }
    }

    // Wide nodes below the wide node that binary node `node` becomes; remembered for write().
    std::uint32_t count_below(std::uint32_t node, std::uint32_t depth) {
        const WideChildren children = collapse_.children(node);
        std::uint32_t counts[shared::BVH_WIDTH] = {};
        each_inner(children, tree_.nodes[node].count, [&](std::uint32_t slot) {
            counts[slot] = 1 + count_below(children[slot].node, depth + 1);
        });
        std::uint32_t deepest = depth_;
        while (deepest < depth && !depth_.compare_exchange_weak(deepest, depth)) {}
        return below_[node] = std::accumulate(std::begin(counts), std::end(counts), 0u);
    }

    // Writes node `index` and what is below it: nodes from `next_node` on, items from `next_item` on.
    void write(std::uint32_t node, std::uint32_t index, std::uint32_t next_node, std::uint32_t next_item) {
        const WideChildren children = arrange(tree_, node, collapse_.children(node));
        shared::BvhNode& out = bvh_.nodes[index];
        out = {};
        out.child_base = next_node;
        out.triangle_base = next_item;
        write_boxes(tree_.nodes[node].box, children, out);
        next_item = write_leaves(children, next_item, out);

        const std::uint32_t inner = bits_of(children, ChildKind::inner);
        out.exponents |= inner << 24;
        next_node += std::uint32_t(std::popcount(inner));
        struct Place {
            std::uint32_t index, next_node, next_item;
        } places[shared::BVH_WIDTH] = {};
        for (std::uint32_t slot = 0, rank = 0; slot < shared::BVH_WIDTH; ++slot) {
            if (children[slot].kind != ChildKind::inner) continue;
            places[slot] = {out.child_base + rank++, next_node, next_item};
            next_node += below_[children[slot].node];
            next_item += tree_.nodes[children[slot].node].count;
        }
        each_inner(children, tree_.nodes[node].count, [&](std::uint32_t slot) {
            write(children[slot].node, places[slot].index, places[slot].next_node, places[slot].next_item);
        });
    }

    void write_boxes(const Box& box, const WideChildren& children, shared::BvhNode& out) const {
        std::uint32_t* lower[3] = {out.lower_x, out.lower_y, out.lower_z};
        std::uint32_t* upper[3] = {out.upper_x, out.upper_y, out.upper_z};
        for (int axis = 0; axis < 3; ++axis) {
            const Grid grid = fit_grid(box.lower[axis], box.upper[axis]);
            out.origin[axis] = grid.origin;
            out.exponents |= std::uint32_t(grid.exponent + 127) << (8 * axis);
            for (std::uint32_t slot = 0; slot < shared::BVH_WIDTH; ++slot) {
                const bool empty = children[slot].kind == ChildKind::empty;
                const Box& child = tree_.nodes[children[slot].node].box;
                put_byte(lower[axis], slot, empty ? 255 : std::floor(grid.place(child.lower[axis]) - MARGIN));
                put_byte(upper[axis], slot, empty ? 0 : std::ceil(grid.place(child.upper[axis]) + MARGIN));
            }
        }
    }

    // First triangles of all leaves, then the second ones, then the third: the order of the bits in `leaves`.
    std::uint32_t write_leaves(const WideChildren& children, std::uint32_t next_item, shared::BvhNode& out) {
        for (std::uint32_t k = 0; k < shared::BVH_MAX_LEAF; ++k) {
            for (std::uint32_t slot = 0; slot < shared::BVH_WIDTH; ++slot) {
                const BinaryNode& leaf = tree_.nodes[children[slot].node];
                if (children[slot].kind != ChildKind::leaf || leaf.count <= k) continue;
                out.leaves |= 1u << (slot + k * shared::BVH_WIDTH);
                bvh_.order[next_item++] = tree_.order[leaf.first + k];
            }
        }
        return next_item;
    }

    const BinaryTree& tree_;
    const Collapse& collapse_;
    Bvh& bvh_;
    std::vector<std::uint32_t> below_;
    std::atomic<std::uint32_t> depth_ = 0;
};

} // namespace

void encode(const BinaryTree& tree, const Collapse& collapse, Bvh& bvh) {
    Encoder(tree, collapse, bvh).run();
}

Box decode_slot(const shared::BvhNode& node, std::uint32_t slot) {
    const std::uint32_t* lower[3] = {node.lower_x, node.lower_y, node.lower_z};
    const std::uint32_t* upper[3] = {node.upper_x, node.upper_y, node.upper_z};
    Box box;
    for (int axis = 0; axis < 3; ++axis) {
        const double step = std::ldexp(1.0, int(node.exponents >> (8 * axis) & 0xff) - 127);
        const auto plane = [&](const std::uint32_t* words) {
            return node.origin[axis] + step * (words[slot / 4] >> (slot % 4 * 8) & 0xff);
        };
        box.lower[axis] = float(plane(lower[axis]));
        box.upper[axis] = float(plane(upper[axis]));
    }
    return box;
}

} // namespace ajar::bvh
