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

// Bit s of a mask of slots moved to s ^ key.
std::uint32_t order_bits(std::uint32_t slots, std::uint32_t key) {
    std::uint32_t bits = 0;
    for (std::uint32_t slot = 0; slot < shared::BVH_WIDTH; ++slot)
        bits |= (slots >> slot & 1) << (slot ^ key);
    return bits;
}

// Finds places for children, which lie at base + slot: slots without an inner child leave gaps, and other
// nodes' children go into them (row displacement, as in the packing of sparse tables). Old gaps are given up,
// so that nodes that are near in the tree stay near in memory.
class Places {
  public:
    // The base for children in the slots of `mask`.
    std::uint32_t take(std::uint32_t mask) {
        std::uint32_t base = std::uint32_t(used_.size()) > REACH ? std::uint32_t(used_.size()) - REACH : 1;
        while (collides(base, mask)) ++base;
        if (used_.size() < base + shared::BVH_WIDTH) used_.resize(base + shared::BVH_WIDTH);
        for (std::uint32_t slot = 0; slot < shared::BVH_WIDTH; ++slot) {
            if (mask >> slot & 1) used_[base + slot] = true, end_ = std::max(end_, base + slot + 1);
        }
        return base;
    }
    std::uint32_t end() const { return end_; }

  private:
    static constexpr std::uint32_t REACH = 64;

    bool collides(std::uint32_t base, std::uint32_t mask) const {
        for (std::uint32_t slot = 0; slot < shared::BVH_WIDTH; ++slot) {
            if ((mask >> slot & 1) != 0 && base + slot < used_.size() && used_[base + slot]) return true;
        }
        return false;
    }

    std::vector<bool> used_ = {true}; // place 0: the root
    std::uint32_t end_ = 1;
};

// A wide node on its way into the table.
struct WideNode {
    WideChildren children;                                   // in their slots
    std::uint32_t node = 0;                                  // the binary node it was
    std::uint32_t first_item = 0;                            // of its own leaves, in leaf order
    std::uint32_t base = 0;                                  // place of slot 0
    std::array<std::uint32_t, shared::BVH_WIDTH> ordinals{}; // of inner children
};

class Encoder {
  public:
    Encoder(const BinaryTree& tree, const Collapse& collapse, Bvh& bvh)
        : tree_(tree), collapse_(collapse), bvh_(bvh), counts_(tree.nodes.size()) {}

    void run() {
        wide_.resize(count(0, 1));
        collect(0, 0, 0);
        // Places depend on all nodes before: the only step that one thread does alone.
        std::vector<std::uint32_t> place(wide_.size());
        Places places;
        for (WideNode& wide : wide_) {
            const std::uint32_t inner = bits_of(wide.children, ChildKind::inner);
            if (inner == 0) continue;
            wide.base = places.take(inner);
            for (std::uint32_t slot = 0; slot < shared::BVH_WIDTH; ++slot) {
                if (inner >> slot & 1) place[wide.ordinals[slot]] = wide.base + slot;
            }
        }
        bvh_.nodes.assign(places.end(), {});
        bvh_.order.resize(tree_.order.size());
        tbb::parallel_for(std::size_t(0), wide_.size(),
                          [&](std::size_t i) { write(wide_[i], bvh_.nodes[place[i]]); });
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

    // Wide nodes of the wide node that binary node `node` becomes and below it; remembered for collect().
    std::uint32_t count(std::uint32_t node, std::uint32_t depth) {
        const WideChildren children = collapse_.children(node);
        std::uint32_t below[shared::BVH_WIDTH] = {};
        each_inner(children, tree_.nodes[node].count,
                   [&](std::uint32_t slot) { below[slot] = count(children[slot].node, depth + 1); });
        std::uint32_t deepest = depth_;
        while (deepest < depth && !depth_.compare_exchange_weak(deepest, depth)) {}
        return counts_[node] = std::accumulate(std::begin(below), std::end(below), 1u);
    }

    // Fills wide_ from `ordinal` on, depth first.
    void collect(std::uint32_t node, std::uint32_t ordinal, std::uint32_t first_item) {
        WideNode& wide = wide_[ordinal];
        wide.children = arrange(tree_, node, collapse_.children(node));
        wide.node = node;
        wide.first_item = first_item;
        for (const WideChild& child : wide.children) {
            if (child.kind == ChildKind::leaf) first_item += tree_.nodes[child.node].count;
        }
        std::array<std::uint32_t, shared::BVH_WIDTH> items{};
        for (std::uint32_t slot = 0, next = ordinal + 1; slot < shared::BVH_WIDTH; ++slot) {
            const WideChild& child = wide.children[slot];
            if (child.kind != ChildKind::inner) continue;
            wide.ordinals[slot] = next;
            items[slot] = first_item;
            next += counts_[child.node];
            first_item += tree_.nodes[child.node].count;
        }
        each_inner(wide.children, tree_.nodes[node].count, [&](std::uint32_t slot) {
            collect(wide.children[slot].node, wide.ordinals[slot], items[slot]);
        });
    }

    void write(const WideNode& wide, shared::BvhNode& out) {
        const std::uint32_t inner = bits_of(wide.children, ChildKind::inner);
        out.inner_orders =
            inner | order_bits(inner, 1) << 8 | order_bits(inner, 2) << 16 | order_bits(inner, 3) << 24;
        out.child_base = wide.base << 8;
        out.triangle_base = wide.first_item;
        std::uint32_t item = wide.first_item;
        for (std::uint32_t slot = 0; slot < shared::BVH_WIDTH; ++slot) {
            if (wide.children[slot].kind != ChildKind::leaf) continue;
            const BinaryNode& leaf = tree_.nodes[wide.children[slot].node];
            for (std::uint32_t k = 0; k < leaf.count; ++k) {
                out.leaves |= 1u << (shared::BVH_MAX_LEAF * slot + k);
                bvh_.order[item++] = tree_.order[leaf.first + k];
            }
        }
        write_boxes(tree_.nodes[wide.node].box, wide.children, out);
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

    const BinaryTree& tree_;
    const Collapse& collapse_;
    Bvh& bvh_;
    std::vector<std::uint32_t> counts_; // by binary node
    std::vector<WideNode> wide_;        // depth first
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
