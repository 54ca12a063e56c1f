#include "bake/charts.hpp"

#include "bake/flat.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <queue>
#include <tuple>

namespace ajar {

namespace {

constexpr std::uint32_t NONE = 0xffffffffu;

// Across each edge (k: from corner k to the next) the one triangle that shares it; NONE where there is no
// other, or more than one. Edges are equal where their ends are, to the bit, within an instance.
std::vector<std::array<std::uint32_t, 3>> neighbours(const std::vector<PlacedTriangle>& triangles) {
    struct Edge {
        std::uint32_t instance;
        glm::dvec3 low, high;
        std::uint32_t triangle, side;
        auto key() const { return std::tuple(instance, low.x, low.y, low.z, high.x, high.y, high.z); }
        bool operator<(const Edge& o) const {
            return std::tuple(key(), triangle, side) < std::tuple(o.key(), o.triangle, o.side);
        }
    };
    const auto before = [](const glm::dvec3& a, const glm::dvec3& b) {
        return std::tuple(a.x, a.y, a.z) < std::tuple(b.x, b.y, b.z);
    };
    std::vector<Edge> edges;
    edges.reserve(triangles.size() * 3);
    for (std::uint32_t t = 0; t < triangles.size(); ++t)
        for (std::uint32_t k = 0; k < 3; ++k) {
            const glm::dvec3 a = triangles[t].corners[k], b = triangles[t].corners[(k + 1) % 3];
            edges.push_back({triangles[t].instance, before(a, b) ? a : b, before(a, b) ? b : a, t, k});
        }
    std::sort(edges.begin(), edges.end());
    std::vector<std::array<std::uint32_t, 3>> across(triangles.size(), {NONE, NONE, NONE});
    for (std::size_t first = 0; first < edges.size();) {
        std::size_t end = first;
        while (end < edges.size() && edges[end].key() == edges[first].key()) ++end;
        if (end - first == 2) {
            const Edge &a = edges[first], &b = edges[first + 1];
            across[a.triangle][a.side] = b.triangle;
            across[b.triangle][b.side] = a.triangle;
        }
        first = end;
    }
    return across;
}

glm::dvec3 twice_area(const PlacedTriangle& t) {
    return glm::cross(t.corners[1] - t.corners[0], t.corners[2] - t.corners[0]);
}

class ChartMaker {
  public:
    explicit ChartMaker(Charts& charts) : charts_(charts), across_(neighbours(charts.triangles)) {
        for (const PlacedTriangle& t : charts.triangles) normals_.push_back(glm::normalize(twice_area(t)));
        charts.chart_of.assign(charts.triangles.size(), NONE);
        charts.flat_corners.resize(charts.triangles.size());
    }

    // From the largest triangle on, so that a chart's plane is that of what is large in it.
    void run() {
        std::vector<std::uint32_t> order(charts_.triangles.size());
        std::iota(order.begin(), order.end(), 0u);
        std::vector<double> areas;
        for (const PlacedTriangle& t : charts_.triangles) areas.push_back(glm::length(twice_area(t)));
        std::stable_sort(order.begin(), order.end(),
                         [&](std::uint32_t a, std::uint32_t b) { return areas[a] > areas[b]; });
        for (const std::uint32_t seed : order)
            if (charts_.chart_of[seed] == NONE) add_chart(seed);
    }

  private:
    // What hangs together with the seed and is turned away from it by less than CHART_ANGLE, the least turned
    // first.
    std::vector<std::uint32_t> grow(std::uint32_t seed) {
        struct Reached {
            double turn;
            std::uint32_t triangle;
            bool operator<(const Reached& o) const { // the queue's top is the greatest
                return turn != o.turn ? turn > o.turn : triangle > o.triangle;
            }
        };
        const auto number = static_cast<std::uint32_t>(charts_.charts.size());
        std::vector<std::uint32_t> members;
        std::priority_queue<Reached> reached;
        reached.push({0, seed});
        while (!reached.empty()) {
            const std::uint32_t t = reached.top().triangle;
            reached.pop();
            if (charts_.chart_of[t] != NONE) continue;
            charts_.chart_of[t] = number;
            members.push_back(t);
            for (const std::uint32_t next : across_[t]) {
                if (next == NONE || charts_.chart_of[next] != NONE) continue;
                const double cosine = glm::dot(normals_[seed], normals_[next]);
                if (cosine > std::cos(CHART_ANGLE)) reached.push({1 - cosine, next});
            }
        }
        return members;
    }

    void add_chart(std::uint32_t seed) {
        const std::vector<std::uint32_t> members = grow(seed);
        const glm::dvec3 n = normals_[seed];
        const glm::dvec3 x = glm::normalize(std::abs(n.x) < 0.7 ? glm::cross(n, glm::dvec3(1, 0, 0))
                                                                : glm::cross(n, glm::dvec3(0, 1, 0)));
        const glm::dvec3 y = glm::cross(n, x), origin = charts_.triangles[seed].corners[0];
        std::vector<FlatTriangle> flat;
        for (const std::uint32_t t : members) {
            FlatTriangle& f = flat.emplace_back();
            for (std::size_t k = 0; k < 3; ++k) {
                const glm::dvec3 p = charts_.triangles[t].corners[k] - origin;
                f[k] = {glm::dot(p, x), glm::dot(p, y)};
            }
        }
        // A ramp that winds up over itself: later turns find a chart of their own.
        const std::vector<bool> keep = without_overlap(flat);
        Chart chart;
        std::vector<FlatTriangle> kept;
        for (std::size_t i = 0; i < members.size(); ++i) {
            if (!keep[i]) {
                charts_.chart_of[members[i]] = NONE;
                continue;
            }
            chart.triangles.push_back(members[i]);
            kept.push_back(flat[i]);
        }
        chart.extent = lay_into_smallest_rectangle(kept);
        for (std::size_t i = 0; i < kept.size(); ++i) charts_.flat_corners[chart.triangles[i]] = kept[i];
        charts_.charts.push_back(std::move(chart));
    }

    Charts& charts_;
    std::vector<std::array<std::uint32_t, 3>> across_;
    std::vector<glm::dvec3> normals_; // unit
};

} // namespace

std::vector<PlacedTriangle> placed_triangles(const Scene& scene) {
    std::vector<PlacedTriangle> result;
    for (std::uint32_t i = 0; i < scene.instances.size(); ++i) {
        const Instance& instance = scene.instances[i];
        const Mesh& mesh = scene.meshes[instance.mesh];
        for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
            PlacedTriangle placed{i, t, {}};
            for (int k = 0; k < 3; ++k) // rounded, as the device has them
                placed.corners[static_cast<std::size_t>(k)] =
                    glm::vec3(instance.to_world * glm::vec4(mesh.positions[mesh.triangles[t][k]], 1));
            const glm::dvec3 area = twice_area(placed);
            if (std::isnormal(glm::dot(area, area))) result.push_back(placed);
        }
    }
    return result;
}

Charts make_charts(std::vector<PlacedTriangle> triangles) {
    Charts charts;
    charts.triangles = std::move(triangles);
    ChartMaker(charts).run();
    return charts;
}

} // namespace ajar
