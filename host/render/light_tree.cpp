#include "render/light_tree.hpp"

#include "base/clock.hpp"
#include "base/error.hpp"
#include "render/octahedral.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <fmt/format.h>
#include <numbers>
#include <tbb/parallel_invoke.h>

namespace ajar {

namespace {

using shared::LightTreeNode;

constexpr std::size_t MAX_LIGHTS = 1u << 24;
constexpr std::size_t PARALLEL_LIGHTS = 4096; // fewer are one thread's work
constexpr std::uint32_t BINS = 12;
// Cones are widened by what octahedral directions and float arithmetic may be off, radians.
constexpr float CONE_SLACK = 2e-4f;

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

LightTreeNode encode(const LightBounds& b, std::uint32_t child) {
    LightTreeNode node{};
    node.center = 0.5f * b.lower + 0.5f * b.upper;
    node.radius = 0.5f * glm::length(b.upper - b.lower) * (1 + 1e-5f);
    node.axis = octahedral_encode(b.axis);
    const auto snorm = [](float cosine, float slack) {
        const float wider =
            std::cos(std::min(std::acos(std::clamp(cosine, -1.0f, 1.0f)) + slack, std::numbers::pi_v<float>));
        return static_cast<std::uint32_t>(static_cast<std::int32_t>(std::floor(wider * 32767.0f))) & 0xffffu;
    };
    node.cones = snorm(b.cos_normals, CONE_SLACK) | snorm(b.cos_emission, 0) << 16;
    node.intensity = static_cast<float>(std::min(b.intensity, 1e30)); // sums and ratios stay finite
    node.child = child | (b.two_sided ? shared::LIGHT_TREE_TWO_SIDED : 0u);
    return node;
}

class Builder {
  public:
    Builder(std::vector<Item> items, LightTree& tree) : items_(std::move(items)), tree_(tree) {}

    void build() {
        tree_.nodes.resize(2 * items_.size());
        const Built root = build(items_, 1, 0, 0);
        tree_.nodes[0] = encode(root.bounds, root.child);
        tree_.depth = root.depth;
    }

  private:
    struct Built {
        LightBounds bounds;
        std::uint32_t child; // the node's, see LightTreeNode
        std::uint32_t depth; // decisions below
    };

    // The subtree over `items`, whose pairs are those from `pair` on: one fewer than it has lights.
    Built build(std::span<Item> items, std::uint32_t pair, std::uint32_t depth, std::uint32_t trail) {
        if (items.size() == 1) {
            tree_.trails[items[0].light] = trail;
            return {items[0].bounds, items[0].light | shared::LIGHT_TREE_LEAF, 0};
        }
        const std::size_t middle = partition(items, depth);
        const auto left_count = static_cast<std::uint32_t>(middle);
        Built left{};
        Built right{};
        const auto build_left = [&] { left = build(items.first(middle), pair + 1, depth + 1, trail); };
        const auto build_right = [&] {
            right = build(items.subspan(middle), pair + left_count, depth + 1, trail | 1u << depth);
        };
        if (items.size() < PARALLEL_LIGHTS) {
            build_left();
            build_right();
        } else {
            tbb::parallel_invoke(build_left, build_right);
        }
        tree_.nodes[2 * pair] = encode(left.bounds, left.child);
        tree_.nodes[2 * pair + 1] = encode(right.bounds, right.child);
        return {merge(left.bounds, right.bounds), pair, 1 + std::max(left.depth, right.depth)};
    }

    // How many items form the left side; at least one on each. Halves where nothing tells them apart, and
    // where the depth that is left is only just enough for halves.
    static std::size_t partition(std::span<Item> items, std::uint32_t depth) {
        const std::uint32_t left = shared::LIGHT_TREE_MAX_DEPTH - depth;
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
    LightTree& tree_;
};

} // namespace

LightBounds merge(const LightBounds& a, const LightBounds& b) {
    LightBounds both;
    both.lower = glm::min(a.lower, b.lower);
    both.upper = glm::max(a.upper, b.upper);
    both.cos_emission = std::min(a.cos_emission, b.cos_emission);
    both.two_sided = a.two_sided || b.two_sided;
    both.intensity = a.intensity + b.intensity;
    // Not acos, which loses half the digits of small angles.
    const float between = std::atan2(glm::length(glm::cross(a.axis, b.axis)), glm::dot(a.axis, b.axis));
    const float angle_a = std::acos(std::clamp(a.cos_normals, -1.0f, 1.0f));
    const float angle_b = std::acos(std::clamp(b.cos_normals, -1.0f, 1.0f));
    const LightBounds& wider = angle_a >= angle_b ? a : b;
    const LightBounds& other = angle_a >= angle_b ? b : a;
    both.axis = wider.axis;
    both.cos_normals = wider.cos_normals;
    const float narrow = std::min(angle_a, angle_b);
    const float wide = std::max(angle_a, angle_b);
    if (between + narrow <= wide) return both;
    const float angle = 0.5f * (between + narrow + wide);
    // In the plane of both axes, so that the new cone touches both. Opposite axes have no such plane.
    const glm::vec3 across = other.axis - glm::dot(other.axis, wider.axis) * wider.axis;
    const float length = glm::length(across);
    const bool opposite = !(length > 1e-6f) && between > 1;
    if (angle >= std::numbers::pi_v<float> || opposite) {
        both.cos_normals = -1;
        return both;
    }
    if (!(length > 1e-6f)) return both; // the same axis but for rounding, which CONE_SLACK covers
    const float turn = angle - wide;
    both.axis = glm::normalize(std::cos(turn) * wider.axis + std::sin(turn) / length * across);
    both.cos_normals = std::cos(angle);
    return both;
}

LightTree build_light_tree(std::span<const LightBounds> lights) {
    const Clock::time_point start = Clock::now();
    if (lights.size() > MAX_LIGHTS)
        throw Error(fmt::format("lights: {} of them: at most {} are possible (merge some)", lights.size(),
                                MAX_LIGHTS));
    LightTree tree;
    tree.trails.assign(lights.size(), shared::NO_TRAIL);
    std::vector<Item> items;
    for (std::uint32_t i = 0; i < lights.size(); ++i)
        if (lights[i].intensity > 0) items.push_back({lights[i], i});
    if (!items.empty()) Builder(std::move(items), tree).build();
    tree.seconds = seconds_since(start);
    return tree;
}

} // namespace ajar
