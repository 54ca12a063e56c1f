// Binned SAH: Wald 2007, "On fast Construction of SAH-based Bounding Volume Hierarchies".
#include "bvh/binary_tree.hpp"

#include <bit>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>
#include <tbb/parallel_reduce.h>

namespace ajar::bvh {
namespace {

constexpr std::uint32_t BINS = 32;
constexpr std::uint32_t FEW_ITEMS = 32;          // of which every plane between two centres is tried
constexpr std::uint32_t PARALLEL_SUBTREE = 2048; // items worth a task of their own
constexpr std::uint32_t PARALLEL_BINNING = 1u << 16;
constexpr std::uint32_t BINNING_GRAIN = 1u << 14;
// A split is taken only while halving could still finish above this depth, so that no input makes a deep
// tree.
constexpr std::uint32_t MAX_BINARY_DEPTH = 60;

// A box to sort, its index in the fourth float.
struct Item {
    Box box;
    std::uint32_t index() const { return std::bit_cast<std::uint32_t>(box.lower[3]); }
    // Halves first: the sum of two large floats may overflow.
    float center(int axis) const { return 0.5f * box.lower[axis] + 0.5f * box.upper[axis]; }
};

struct Extent {
    Box items;
    Box centers;
    void include(const Item& item) {
        items.include(item.box);
        centers.include(glm::vec3(item.center(0), item.center(1), item.center(2)));
    }
    void include(const Extent& other) {
        items.include(other.items);
        centers.include(other.centers);
    }
};

// Maps centres to bins; the same function bins and partitions, so both always agree.
struct Binning {
    float lower[3];
    float scale[3]; // 0: all centres coincide on that axis

    explicit Binning(const Box& centers) {
        for (int axis = 0; axis < 3; ++axis) {
            const float extent = centers.upper[axis] - centers.lower[axis];
            const float s = float(BINS) * 0.9999f / extent;
            lower[axis] = centers.lower[axis];
            scale[axis] = extent > 0 && std::isfinite(s) ? s : 0;
        }
    }
    std::uint32_t bin(const Item& item, int axis) const {
        const float place = (item.center(axis) - lower[axis]) * scale[axis];
        return std::uint32_t(std::min(place > 0 ? place : 0, float(BINS - 1))); // NaN (overflow): bin 0
    }
};

struct Bins {
    Box boxes[3][BINS];
    std::uint32_t counts[3][BINS] = {};

    void add(const Binning& binning, std::span<const Item> items) {
        for (const Item& item : items) {
            for (int axis = 0; axis < 3; ++axis) {
                const std::uint32_t b = binning.bin(item, axis);
                boxes[axis][b].include(item.box);
                ++counts[axis][b];
            }
        }
    }
    void add(const Bins& other) {
        for (int axis = 0; axis < 3; ++axis) {
            for (std::uint32_t b = 0; b < BINS; ++b) {
                boxes[axis][b].include(other.boxes[axis][b]);
                counts[axis][b] += other.counts[axis][b];
            }
        }
    }
};

struct Split {
    int axis = -1;         // -1: no plane separates the items
    std::uint32_t bin = 0; // first bin on the right
    std::uint32_t left_count = 0;
};

Split best_split(const Binning& binning, const Bins& bins) {
    Split best;
    double best_cost = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
        if (binning.scale[axis] == 0) continue;
        double right_costs[BINS];
        Box box;
        std::uint32_t count = 0;
        for (std::uint32_t b = BINS - 1; b > 0; --b) {
            box.include(bins.boxes[axis][b]);
            count += bins.counts[axis][b];
            right_costs[b] = box.half_area() * count;
        }
        const std::uint32_t total = count + bins.counts[axis][0];
        box = {};
        count = 0;
        for (std::uint32_t b = 1; b < BINS; ++b) {
            box.include(bins.boxes[axis][b - 1]);
            count += bins.counts[axis][b - 1];
            const double cost = box.half_area() * count + right_costs[b];
            if (count > 0 && count < total && cost < best_cost) best = {axis, b, count}, best_cost = cost;
        }
    }
    return best;
}

// Of the planes between two centres the best; the items are left in order along its axis.
std::uint32_t sweep(std::span<Item> items) {
    std::uint32_t best_left = 0;
    int best_axis = 0;
    double best_cost = std::numeric_limits<double>::infinity();
    const auto sort = [items](int axis) {
        std::sort(items.begin(), items.end(), [axis](const Item& a, const Item& b) {
            const float x = a.center(axis), y = b.center(axis);
            return x != y ? x < y : a.index() < b.index();
        });
    };
    for (int axis = 0; axis < 3; ++axis) {
        sort(axis);
        double right_costs[FEW_ITEMS];
        Box box;
        for (std::size_t i = items.size() - 1; i > 0; --i) {
            box.include(items[i].box);
            right_costs[i] = box.half_area() * double(items.size() - i);
        }
        box = {};
        for (std::size_t i = 1; i < items.size(); ++i) {
            box.include(items[i - 1].box);
            const double cost = box.half_area() * double(i) + right_costs[i];
            if (cost < best_cost) best_cost = cost, best_axis = axis, best_left = std::uint32_t(i);
        }
    }
    if (best_axis != 2) sort(best_axis);
    return best_left;
}

class Builder {
  public:
    Builder(std::span<const Box> boxes, SplitRule rule) : rule_(rule), items_(boxes.size()) {
        tree_.nodes.resize(2 * boxes.size() - 1);
        tree_.order.resize(boxes.size());
        tbb::parallel_for(tbb::blocked_range<std::size_t>(0, boxes.size(), BINNING_GRAIN),
                          [&](const auto& range) {
                              for (std::size_t i = range.begin(); i < range.end(); ++i) {
                                  items_[i].box = boxes[i];
                                  items_[i].box.lower[3] = std::bit_cast<float>(std::uint32_t(i));
                              }
                          });
    }

    BinaryTree build() {
        build_subtree(0, 0, std::uint32_t(items_.size()), 0);
        return std::move(tree_);
    }

  private:
    void build_subtree(std::uint32_t node_index, std::uint32_t first, std::uint32_t count,
                       std::uint32_t depth) {
        const std::span<Item> items(items_.data() + first, count);
        BinaryNode& node = tree_.nodes[node_index];
        node.first = first;
        node.count = count;
        if (count == 1) {
            node.box = items[0].box;
            tree_.order[first] = items[0].index();
            return;
        }
        const Extent extent = measure(items);
        node.box = extent.items;
        const std::uint32_t left = split(items, extent, depth);
        node.right = node_index + 2 * left;
        const auto build_left = [&, this] { build_subtree(node_index + 1, first, left, depth + 1); };
        const auto build_right = [&, this] {
            build_subtree(node.right, first + left, count - left, depth + 1);
        };
        if (count >= PARALLEL_SUBTREE) {
            tbb::parallel_invoke(build_left, build_right);
        } else {
            build_left();
            build_right();
        }
    }

    static Extent measure(std::span<const Item> items) {
        const auto add = [&](const tbb::blocked_range<std::size_t>& range, Extent extent) {
            for (std::size_t i = range.begin(); i < range.end(); ++i) extent.include(items[i]);
            return extent;
        };
        const tbb::blocked_range<std::size_t> all(0, items.size(), BINNING_GRAIN);
        if (items.size() < PARALLEL_BINNING) return add(all, {});
        // Minimum and maximum do not depend on the order in which threads meet.
        return tbb::parallel_reduce(all, Extent{}, add, [](Extent a, const Extent& b) {
            a.include(b);
            return a;
        });
    }

    // Reorders the items and returns how many are on the left, at least one and not all.
    std::uint32_t split(std::span<Item> items, const Extent& extent, std::uint32_t depth) const {
        const auto count = std::uint32_t(items.size());
        if (count == 2) return 1;
        if (rule_ == SplitRule::median) return halve(items, extent.centers);
        if (count <= FEW_ITEMS && depth + count <= MAX_BINARY_DEPTH) {
            if (const std::uint32_t left = sweep(items); left > 0) return left;
        }
        const Binning binning(extent.centers);
        const Split best = best_split(binning, fill(binning, items));
        const std::uint32_t larger = std::max(best.left_count, count - best.left_count);
        if (best.axis < 0 || depth + 1 + std::uint32_t(std::bit_width(larger)) > MAX_BINARY_DEPTH)
            return halve(items, extent.centers);
        std::partition(items.begin(), items.end(),
                       [&](const Item& item) { return binning.bin(item, best.axis) < best.bin; });
        return best.left_count;
    }

    static std::uint32_t halve(std::span<Item> items, const Box& centers) {
        int axis = 0;
        for (int i = 1; i < 3; ++i) {
            if (centers.upper[i] - centers.lower[i] > centers.upper[axis] - centers.lower[axis]) axis = i;
        }
        const std::size_t half = items.size() / 2;
        std::nth_element(items.begin(), items.begin() + std::ptrdiff_t(half), items.end(),
                         [axis](const Item& a, const Item& b) {
                             if (a.center(axis) != b.center(axis)) return a.center(axis) < b.center(axis);
                             return a.index() < b.index();
                         });
        return std::uint32_t(half);
    }

    static Bins fill(const Binning& binning, std::span<const Item> items) {
        if (items.size() < PARALLEL_BINNING) {
            Bins bins;
            bins.add(binning, items);
            return bins;
        }
        return tbb::parallel_reduce(
            tbb::blocked_range<std::size_t>(0, items.size(), BINNING_GRAIN), Bins{},
            [&](const auto& range, Bins bins) {
                bins.add(binning, items.subspan(range.begin(), range.size()));
                return bins;
            },
            [](Bins a, const Bins& b) {
                a.add(b);
                return a;
            });
    }

    SplitRule rule_;
    std::vector<Item> items_;
    BinaryTree tree_;
};

} // namespace

BinaryTree build_binary_tree(std::span<const Box> boxes, SplitRule rule) {
    return Builder(boxes, rule).build();
}

} // namespace ajar::bvh
