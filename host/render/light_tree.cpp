// The wide light tree: what a node takes in, and in what order its nodes lie.
#include "render/light_tree.hpp"

#include "base/clock.hpp"
#include "base/error.hpp"
#include "render/light_tree_binary.hpp"
#include "render/light_tree_code.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace ajar {

namespace {

constexpr std::size_t MAX_LIGHTS = 1u << 24;

// Makes the wide tree of the binary one: a node takes in its descendants, the one that may light most of its
// surroundings first, until it has four children.
class Collapser {
  public:
    Collapser(std::vector<BinaryNode> binary, LightTree& tree) : binary_(std::move(binary)), tree_(tree) {}

    void collapse() {
        Sphere sphere;
        tree_.root = encode_light_tree_root(binary_[0].bounds, sphere);
        tree_.empty = false;
        tree_.nodes.resize(1);
        fill(0, binary_[0], sphere, 0, 0);
    }

  private:
    using Children = std::vector<const BinaryNode*>;

    void take_in(Children& children, std::size_t k) const {
        const std::uint32_t first = children[k]->child;
        children[k] = &binary_[first];
        children.push_back(&binary_[first + 1]);
    }

    // Nodes before lights. Two levels of the binary tree where every level counts, so that trails are long
    // enough.
    Children children_of(const BinaryNode& node, std::uint32_t depth) const {
        if (node.is_light()) return {&node}; // the only one
        Children children{&binary_[node.child], &binary_[node.child + 1]};
        if (node.height >= 2 * (shared::LIGHT_TREE_MAX_DEPTH - depth)) {
            for (std::size_t k = 0; k < 2; ++k)
                if (!children[k]->is_light()) take_in(children, k);
        }
        while (children.size() < 4) {
            const auto greatest =
                std::max_element(children.begin(), children.end(),
                                 [](const auto* a, const auto* b) { return a->reach() < b->reach(); });
            if ((*greatest)->is_light()) break;
            take_in(children, static_cast<std::size_t>(greatest - children.begin()));
        }
        std::stable_partition(children.begin(), children.end(), [](const auto* c) { return !c->is_light(); });
        return children;
    }

    // Node `index`, which has its place already, and everything below it.
    void fill(std::uint32_t index, const BinaryNode& binary, const Sphere& sphere, std::uint32_t depth,
              std::uint32_t trail) {
        const Children children = children_of(binary, depth);
        std::vector<const LightBounds*> bounds;
        for (const BinaryNode* child : children) bounds.push_back(&child->bounds);
        std::array<Sphere, 4> spheres;
        shared::LightTreeNode node = encode_light_tree_node(bounds, sphere, spheres);
        const auto first = static_cast<std::uint32_t>(tree_.nodes.size());
        const auto nodes = static_cast<std::uint32_t>(
            std::count_if(children.begin(), children.end(), [](const auto* c) { return !c->is_light(); }));
        node.nodes = nodes << shared::LIGHT_TREE_COUNT_SHIFT | first;
        tree_.nodes.resize(first + nodes);
        tree_.depth = std::max(tree_.depth, depth + 1);
        for (std::uint32_t k = 0; k < children.size(); ++k) {
            const std::uint32_t way = trail | k << (shared::LIGHT_TREE_TRAIL_TOP - 2 - 2 * depth);
            if (k < nodes) {
                fill(first + k, *children[k], spheres[k], depth + 1, way);
            } else {
                node.lights[k] = children[k]->light();
                tree_.trails[node.lights[k]] = way;
            }
        }
        tree_.nodes[index] = node;
    }

    std::vector<BinaryNode> binary_;
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
    if (!(length > 1e-6f)) return both; // the same axis but for rounding
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
    if (std::any_of(lights.begin(), lights.end(), [](const LightBounds& b) { return b.intensity > 0; }))
        Collapser(build_binary_light_tree(lights), tree).collapse();
    tree.seconds = seconds_since(start);
    return tree;
}

} // namespace ajar
