#include "render/light_tree_binary.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <tbb/parallel_invoke.h>

namespace ajar {

namespace {

constexpr std::size_t PARALLEL_LIGHTS = 4096; // fewer are one thread's work
constexpr std::uint32_t BINS = 12;

struct Item {
    LightBounds bounds;
    std::uint32_t light = 0;
    glm::vec3 center() const { return 0.5f * bounds.lower + 0.5f * bounds.upper; }
};

// What a side of a split costs, from sums alone: binning thousands of lights needs no exact cones.
struct Side {
    glm::vec3 lower{INFINITY};
    glm::vec3 upper{-INFINITY};
    glm::vec3 normals{0}; // weighted by intensity; lights without a direction of their own add nothing
    float intensity = 0;
    std::uint32_t count = 0;

    void add(const Item& item) {
        lower = glm::min(lower, item.bounds.lower);
        upper = glm::max(upper, item.bounds.upper);
        const auto weight = static_cast<float>(item.bounds.intensity);
        const bool flat = item.bounds.cos_normals > 0 && !item.bounds.two_sided;
        if (flat) normals += weight * item.bounds.axis;
        intensity += weight;
        ++count;
    }
    void add(const Side& other) {
        lower = glm::min(lower, other.lower);
        upper = glm::max(upper, other.upper);
        normals += other.normals;
        intensity += other.intensity;
        count += other.count;
    }
    // Intensity times solid angle times squared extent. Normals spread evenly in a cone have a mean of length
    // (1 + cos) / 2; the solid angle that flat lights with such normals reach grows from pi to 4 pi.
    float cost() const {
        if (count == 0 || !(intensity > 0)) return 0;
        const float alike = glm::length(normals) / intensity;
        const glm::vec3 extent = upper - lower;
        return intensity * (1 + 3 * (1 - std::min(alike, 1.0f))) * glm::dot(extent, extent);
    }
};

struct Split {
    float cost = INFINITY;
    int axis = -1;
    std::uint32_t bin = 0; // the last one of the left side
};

struct Binning {
    glm::vec3 lower{INFINITY};
    glm::vec3 scale{0};
    glm::vec3 extent{0};

    explicit Binning(std::span<const Item> items) {
        glm::vec3 upper(-INFINITY);
        for (const Item& item : items) {
            lower = glm::min(lower, item.center());
            upper = glm::max(upper, item.center());
        }
        extent = upper - lower;
        for (int a = 0; a < 3; ++a) {
            const float wanted = static_cast<float>(BINS) / extent[a];
            scale[a] = std::isfinite(wanted) ? wanted : 0;
        }
    }
    std::uint32_t bin(const Item& item, int axis) const {
        const float at = (item.center()[axis] - lower[axis]) * scale[axis];
        return std::min(static_cast<std::uint32_t>(std::max(at, 0.0f)), BINS - 1);
    }
    Split best(std::span<const Item> items) const {
        std::array<std::array<Side, BINS>, 3> sides;
        for (const Item& item : items)
            for (int a = 0; a < 3; ++a) sides[static_cast<std::size_t>(a)][bin(item, a)].add(item);
        const float longest = std::max({extent.x, extent.y, extent.z});
        Split split;
        for (int a = 0; a < 3; ++a) {
            if (scale[a] == 0) continue;
            const auto& bins = sides[static_cast<std::size_t>(a)];
            std::array<float, BINS> right_costs{};
            Side right;
            for (std::uint32_t b = BINS - 1; b > 0; --b) {
                right.add(bins[b]);
                right_costs[b - 1] = right.count == 0 ? INFINITY : right.cost();
            }
            Side left;
            for (std::uint32_t b = 0; b + 1 < BINS; ++b) {
                left.add(bins[b]);
                if (left.count == 0) continue;
                // Thin boxes are charged for: spheres around them are mostly empty.
                const float cost = (left.cost() + right_costs[b]) * (longest / extent[a]);
                if (cost < split.cost) split = {cost, a, b};
            }
        }
        return split;
    }
};

class BinaryBuilder {
  public:
    explicit BinaryBuilder(std::vector<Item> items) : items_(std::move(items)) {}

    // Node 0 is the root.
    std::vector<BinaryNode> build() {
        nodes_.resize(2 * items_.size());
        nodes_[0] = build(items_, 1, 0);
        return std::move(nodes_);
    }

  private:
    // The subtree over `items`, whose pairs are those from `pair` on: one fewer than it has lights.
    BinaryNode build(std::span<Item> items, std::uint32_t pair, std::uint32_t depth) {
        if (items.size() == 1) return {items[0].bounds, items[0].light | BINARY_LEAF, 0};
        const std::size_t middle = partition(items, depth);
        const auto left_count = static_cast<std::uint32_t>(middle);
        BinaryNode& left = nodes_[2 * pair];
        BinaryNode& right = nodes_[2 * pair + 1];
        const auto build_left = [&] { left = build(items.first(middle), pair + 1, depth + 1); };
        const auto build_right = [&] { right = build(items.subspan(middle), pair + left_count, depth + 1); };
        if (items.size() < PARALLEL_LIGHTS) {
            build_left();
            build_right();
        } else {
            tbb::parallel_invoke(build_left, build_right);
        }
        return {merge(left.bounds, right.bounds), 2 * pair, 1 + std::max(left.height, right.height)};
    }

    // How many items form the left side; at least one on each. Halves where nothing tells them apart, and
    // where the depth that is left is only just enough for halves.
    static std::size_t partition(std::span<Item> items, std::uint32_t depth) {
        const std::uint32_t left = 2 * shared::LIGHT_TREE_MAX_DEPTH - depth;
        if (static_cast<std::uint32_t>(std::bit_width(items.size() - 1)) < left) {
            const Binning binning(items);
            const Split split = binning.best(items);
            if (split.axis >= 0) {
                const auto middle = std::partition(items.begin(), items.end(), [&](const Item& item) {
                    return binning.bin(item, split.axis) <= split.bin;
                });
                return static_cast<std::size_t>(middle - items.begin());
            }
        }
        return items.size() / 2;
    }

    std::vector<Item> items_;
    std::vector<BinaryNode> nodes_;
};

} // namespace

std::vector<BinaryNode> build_binary_light_tree(std::span<const LightBounds> lights) {
    std::vector<Item> items;
    for (std::uint32_t i = 0; i < lights.size(); ++i)
        if (lights[i].intensity > 0) items.push_back({lights[i], i});
    return BinaryBuilder(std::move(items)).build();
}

} // namespace ajar
