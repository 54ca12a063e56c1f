#include "import/tangent_groups.hpp"

#include <algorithm>
#include <numeric>
#include <tuple>
#include <utility>

namespace ajar::gltf {

std::vector<std::uint32_t> weld(std::span<const glm::vec3> positions, std::span<const glm::vec3> normals,
                                std::span<const glm::vec2> uv) {
    using Key = std::array<float, 8>;
    const auto key = [&](std::uint32_t i) {
        return Key{positions[i].x, positions[i].y, positions[i].z, normals[i].x,
                   normals[i].y,   normals[i].z,   uv[i].x,        uv[i].y};
    };
    std::vector<std::uint32_t> order(positions.size());
    std::iota(order.begin(), order.end(), 0u);
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        const Key ka = key(a), kb = key(b);
        return ka < kb || (!(kb < ka) && a < b);
    });
    std::vector<std::uint32_t> result(positions.size());
    for (std::size_t i = 0; i < order.size(); ++i)
        result[order[i]] = i > 0 && key(order[i]) == key(order[i - 1]) ? result[order[i - 1]] : order[i];
    return result;
}

void connect(std::vector<TangentTriangle>& triangles) {
    struct Edge {
        std::uint32_t low, high, triangle, corner;
        bool forward; // from low to high
    };
    std::vector<Edge> edges;
    edges.reserve(triangles.size() * 3);
    for (std::uint32_t t = 0; t < triangles.size(); ++t) {
        if (triangles[t].is_degenerate) continue;
        for (std::uint32_t k = 0; k < 3; ++k) {
            const std::uint32_t a = triangles[t].vertices[k];
            const std::uint32_t b = triangles[t].vertices[(k + 1) % 3];
            edges.push_back({std::min(a, b), std::max(a, b), t, k, a < b});
        }
    }
    std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) {
        return std::tie(a.low, a.high, a.triangle) < std::tie(b.low, b.high, b.triangle);
    });
    // Those that wait for a partner all run in the same direction; the first to wait is the first to get one.
    std::vector<const Edge*> waiting;
    std::size_t first = 0;
    for (std::size_t i = 0; i < edges.size(); ++i) {
        const Edge& edge = edges[i];
        if (i == 0 || edge.low != edges[i - 1].low || edge.high != edges[i - 1].high)
            waiting.clear(), first = 0;
        if (first == waiting.size() || waiting[first]->forward == edge.forward) {
            waiting.push_back(&edge);
            continue;
        }
        const Edge& partner = *waiting[first++];
        triangles[edge.triangle].neighbours[edge.corner] = partner.triangle;
        triangles[partner.triangle].neighbours[partner.corner] = edge.triangle;
    }
}

namespace {

// Whether the triangle may join the group; one without a direction takes the handedness of the first group it
// meets.
bool joins(TangentTriangle& triangle, const TangentGroup& group) {
    if (triangle.groups[triangle.corner(group.vertex)] != NONE) return false;
    if (triangle.joins_any && triangle.groups == std::array<std::uint32_t, 3>{NONE, NONE, NONE})
        triangle.preserves = group.preserves;
    return triangle.preserves == group.preserves;
}

} // namespace

std::vector<TangentGroup> make_groups(std::vector<TangentTriangle>& triangles) {
    std::vector<TangentGroup> groups;
    std::vector<std::uint32_t> open;
    for (std::uint32_t t = 0; t < triangles.size(); ++t) {
        if (triangles[t].is_degenerate || triangles[t].joins_any) continue;
        for (std::uint32_t k = 0; k < 3; ++k) {
            if (triangles[t].groups[k] != NONE) continue;
            const auto index = static_cast<std::uint32_t>(groups.size());
            TangentGroup group{triangles[t].vertices[k], triangles[t].preserves, {}};
            open.assign(1, t);
            while (!open.empty()) {
                TangentTriangle& triangle = triangles[open.back()];
                const std::uint32_t member = open.back();
                open.pop_back();
                if (!joins(triangle, group)) continue;
                const std::uint32_t corner = triangle.corner(group.vertex);
                triangle.groups[corner] = index;
                group.triangles.push_back(member);
                // Depth first, across the edge that leaves the corner before the one that arrives: the order
                // decides which group a triangle without direction falls to.
                for (const std::uint32_t next :
                     {triangle.neighbours[(corner + 2) % 3], triangle.neighbours[corner]})
                    if (next != NONE) open.push_back(next);
            }
            groups.push_back(std::move(group));
        }
    }
    return groups;
}

} // namespace ajar::gltf
