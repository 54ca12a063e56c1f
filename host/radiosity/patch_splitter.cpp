#include "radiosity/patch_splitter.hpp"

#include "base/error.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <numeric>
#include <utility>

namespace ajar {

using namespace shared;

namespace {

// An edge of less than 16 steps of the floats at its ends is not split: rounding would bend its patches.
constexpr double SHORTEST = 0x1p-19;

} // namespace

PatchSplitter::PatchSplitter(PatchMesh& mesh) : mesh_(mesh), welder_(mesh.positions) {
    const std::size_t count = mesh.patches.size();
    origin_.resize(count);
    std::iota(origin_.begin(), origin_.end(), 0u);
    node_of_.resize(count);
    depth_.resize(count);
    patch_edges_.resize(count);
    next_use_.resize(3 * count, NONE);
    std::vector<std::pair<std::uint32_t, std::uint8_t>> stack; // node, depth
    for (const PatchSource& source : mesh.sources) stack.emplace_back(source.root, 0);
    while (!stack.empty()) {
        const auto [node, depth] = stack.back();
        stack.pop_back();
        const std::uint32_t child = mesh.nodes[node].child;
        if ((child & PATCH_LEAF) != 0) {
            node_of_[child & ~PATCH_LEAF] = node;
            depth_[child & ~PATCH_LEAF] = depth;
        } else {
            for (const std::uint32_t k : {0u, 1u}) stack.emplace_back(child + k, depth + 1);
        }
    }
    for (std::uint32_t p = 0; p < count; ++p) link(p);
}

std::uint32_t PatchSplitter::edge_between(std::uint32_t v, std::uint32_t w) {
    const std::uint32_t a = std::min(v, w);
    const std::uint32_t b = std::max(v, w);
    const auto hash = [](std::uint32_t from, std::uint32_t to) {
        return IndexTable::mix(std::uint64_t{from} << 32 | to);
    };
    return edge_table_.find_or_make(
        hash(a, b), [&](std::uint32_t e) { return edges_[e].a == a && edges_[e].b == b; },
        [&] {
            Edge& edge = edges_.emplace_back();
            edge.a = a;
            edge.b = b;
            return static_cast<std::uint32_t>(edges_.size() - 1);
        },
        [&](std::uint32_t e) { return hash(edges_[e].a, edges_[e].b); });
}

PatchSplitter::Wanted PatchSplitter::wanted(std::uint32_t edge) const {
    const glm::dvec3 d(glm::dvec3(mesh_.positions[edges_[edge].a]) -
                       glm::dvec3(mesh_.positions[edges_[edge].b]));
    return {glm::dot(d, d), edge};
}

std::uint32_t PatchSplitter::longest_edge(std::uint32_t patch) const {
    Wanted longest = wanted(patch_edges_[patch][0]);
    for (const std::size_t k : {1u, 2u})
        if (const Wanted other = wanted(patch_edges_[patch][k]); longest < other) longest = other;
    return longest.edge;
}

void PatchSplitter::link(std::uint32_t patch) {
    const auto& v = mesh_.patches[patch].vertices;
    for (std::uint32_t k = 0; k < 3; ++k) {
        const std::uint32_t edge = edge_between(v[k], v[(k + 1) % 3]);
        patch_edges_[patch][k] = edge;
        next_use_[3 * patch + k] = std::exchange(edges_[edge].first_use, 3 * patch + k);
    }
}

void PatchSplitter::unlink(std::uint32_t patch) {
    for (std::uint32_t k = 0; k < 3; ++k) {
        std::uint32_t* at = &edges_[patch_edges_[patch][k]].first_use;
        while (*at != 3 * patch + k) at = &next_use_[*at];
        *at = next_use_[3 * patch + k];
    }
}

void PatchSplitter::want_all() {
    for (std::uint32_t e = 0; e < edges_.size(); ++e)
        if (edges_[e].first_use != NONE) want_edge(e);
}

void PatchSplitter::want(std::uint32_t patch) { want_edge(longest_edge(patch)); }

// Whether the edge is the longest of all patches that share it. Otherwise what is longer is wanted, and it
// again.
bool PatchSplitter::ready(std::uint32_t edge) {
    bool is_longest = true;
    for (std::uint32_t use = edges_[edge].first_use; use != NONE; use = next_use_[use]) {
        const std::uint32_t longest = longest_edge(use / 3);
        if (longest == edge) continue;
        is_longest = false;
        if (edges_[longest].frozen) edges_[edge].frozen = true;
        want_edge(longest);
    }
    if (!is_longest) want_edge(edge);
    return is_longest;
}

void PatchSplitter::split(double length, std::uint32_t patches, bool follow) {
    while (!queue_.empty() && mesh_.patches.size() < patches) {
        const Wanted top = queue_.top();
        if (top.squared_length <= length * length) return;
        queue_.pop();
        Edge& edge = edges_[top.edge];
        if (edge.first_use == NONE || edge.frozen || !ready(top.edge)) continue;
        for (std::uint32_t use = edge.first_use; use != NONE; use = next_use_[use])
            edge.frozen |= depth_[use / 3] >= PATCH_MAX_DEPTH;
        // Exact halves, so that it is the same from either end.
        const glm::vec3 a = mesh_.positions[edge.a];
        const glm::vec3 b = mesh_.positions[edge.b];
        const glm::vec3 middle = 0.5f * a + 0.5f * b;
        const double reach = std::max(glm::length(glm::dvec3(a)), glm::length(glm::dvec3(b)));
        edge.frozen |= top.squared_length < SHORTEST * SHORTEST * reach * reach;
        if (!edge.frozen) split_edge(top.edge, welder_.vertex(middle), follow);
    }
}

void PatchSplitter::split_edge(std::uint32_t edge, std::uint32_t middle, bool follow) {
    edges_[edge].was_split = true;
    const std::size_t edges_before = edges_.size();
    while (edges_[edge].first_use != NONE) {
        const std::uint32_t use = edges_[edge].first_use;
        const std::uint32_t patch = use / 3;
        const auto second = static_cast<std::uint32_t>(mesh_.patches.size());
        bisect(patch, use % 3, middle);
        // Other surfaces may have had an edge of the same ends: what was split for them is split for all.
        for (const std::uint32_t child : {patch, second})
            for (const std::uint32_t e : patch_edges_[child])
                if (edges_[e].was_split) want_edge(e);
    }
    if (!follow) return;
    for (std::size_t e = edges_before; e < edges_.size(); ++e) want_edge(static_cast<std::uint32_t>(e));
}

// The first child takes the patch's number, the second a new one (PatchNode says which is which).
void PatchSplitter::bisect(std::uint32_t patch, std::uint32_t place, std::uint32_t middle) {
    if (mesh_.patches.size() >= MAX_PATCHES)
        throw Error(fmt::format("radiosity: more than {} patches (choose a larger --patch-size, or fewer "
                                "--patches or steps of --refine)",
                                MAX_PATCHES));
    const auto second = static_cast<std::uint32_t>(mesh_.patches.size());
    unlink(patch);
    const std::uint32_t q = (place + 1) % 3;
    Patch& first = mesh_.patches[patch];
    first.area *= 0.5f;
    Patch other = first;
    const glm::vec2 corner = 0.5f * first.corners[place] + 0.5f * first.corners[q];
    first.vertices[q] = other.vertices[place] = middle;
    first.corners[q] = other.corners[place] = corner;
    mesh_.patches.push_back(other);

    const std::uint32_t node = node_of_[patch];
    const auto child = static_cast<std::uint32_t>(mesh_.nodes.size());
    mesh_.nodes[node] = {child, place, {}};
    mesh_.nodes.push_back({patch | PATCH_LEAF, 0, {}});
    mesh_.nodes.push_back({second | PATCH_LEAF, 0, {}});
    node_of_[patch] = child;
    node_of_.push_back(child + 1);
    depth_.push_back(++depth_[patch]);
    origin_.push_back(origin_[patch]);
    patch_edges_.emplace_back();
    next_use_.resize(next_use_.size() + 3, NONE);
    link(patch);
    link(second);
}

std::vector<std::uint32_t> PatchSplitter::finish() {
    std::vector<Patch> patches;
    std::vector<std::uint32_t> origins;
    std::vector<PatchNode> nodes(mesh_.sources.size());
    nodes.reserve(mesh_.nodes.size());
    patches.reserve(mesh_.patches.size());
    origins.reserve(mesh_.patches.size());
    std::vector<std::pair<std::uint32_t, std::uint32_t>> stack; // a node's old and new place
    for (std::uint32_t s = 0; s < mesh_.sources.size(); ++s) {
        stack.emplace_back(std::exchange(mesh_.sources[s].root, s), s);
        while (!stack.empty()) {
            const auto [from, to] = stack.back();
            stack.pop_back();
            nodes[to] = mesh_.nodes[from];
            const std::uint32_t child = nodes[to].child;
            if ((child & PATCH_LEAF) != 0) {
                nodes[to].child = static_cast<std::uint32_t>(patches.size()) | PATCH_LEAF;
                patches.push_back(mesh_.patches[child & ~PATCH_LEAF]);
                origins.push_back(origin_[child & ~PATCH_LEAF]);
                continue;
            }
            nodes[to].child = static_cast<std::uint32_t>(nodes.size());
            nodes.resize(nodes.size() + 2);
            for (const std::uint32_t k : {1u, 0u}) stack.emplace_back(child + k, nodes[to].child + k);
        }
    }
    std::vector<std::uint32_t> places(mesh_.positions.size(), NONE);
    std::vector<glm::vec3> positions;
    positions.reserve(mesh_.positions.size());
    for (Patch& patch : patches)
        for (std::uint32_t& vertex : patch.vertices) {
            std::uint32_t& place = places[vertex];
            if (place == NONE) {
                place = static_cast<std::uint32_t>(positions.size());
                positions.push_back(mesh_.positions[vertex]);
            }
            vertex = place;
        }
    mesh_.patches = std::move(patches);
    mesh_.nodes = std::move(nodes);
    mesh_.positions = std::move(positions);
    return origins;
}

} // namespace ajar
