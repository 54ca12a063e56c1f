#include "bake/flat.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

namespace ajar {

namespace {

// By this part of the triangles' size corners of neighbours may miss one another: positions are floats.
constexpr double ROUNDING = 1e-5;

double cross(const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; }

struct Range {
    double low, high;
};

Range along(const FlatTriangle& t, const glm::dvec2& axis) {
    const double a = glm::dot(t[0], axis), b = glm::dot(t[1], axis), c = glm::dot(t[2], axis);
    return {std::min({a, b, c}), std::max({a, b, c})};
}

double longest_edge(const FlatTriangle& t) {
    return std::max({glm::length(t[1] - t[0]), glm::length(t[2] - t[1]), glm::length(t[0] - t[2])});
}

// Separating axes: convex shapes are apart if and only if they are along the normal of one of their edges.
bool overlap(const FlatTriangle& a, const FlatTriangle& b) {
    const double slack = ROUNDING * std::min(longest_edge(a), longest_edge(b));
    for (const FlatTriangle* t : {&a, &b})
        for (std::size_t k = 0; k < 3; ++k) {
            const glm::dvec2 edge = (*t)[(k + 1) % 3] - (*t)[k];
            const glm::dvec2 axis = glm::dvec2(-edge.y, edge.x) / glm::length(edge);
            const Range ra = along(a, axis), rb = along(b, axis);
            if (std::min(ra.high, rb.high) - std::max(ra.low, rb.low) <= slack) return false;
        }
    return true;
}

// Andrew's monotone chain, counter-clockwise.
std::vector<glm::dvec2> convex_hull(std::vector<glm::dvec2> points) {
    std::sort(points.begin(), points.end(),
              [](const glm::dvec2& a, const glm::dvec2& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
    std::vector<glm::dvec2> hull;
    for (const int pass : {0, 1}) {
        const std::size_t begin = hull.size();
        for (const glm::dvec2& p : points) {
            while (hull.size() >= begin + 2 &&
                   cross(hull.back() - hull[hull.size() - 2], p - hull[hull.size() - 2]) <= 0)
                hull.pop_back();
            hull.push_back(p);
        }
        hull.pop_back(); // the next pass begins with it
        if (pass == 0) std::reverse(points.begin(), points.end());
    }
    return hull;
}

struct Rectangle {
    glm::dvec2 x{1, 0}; // unit, along its longer side
    Range range_x{}, range_y{};
};

Rectangle smallest_rectangle(const std::vector<FlatTriangle>& triangles) {
    std::vector<glm::dvec2> points;
    for (const FlatTriangle& t : triangles) points.insert(points.end(), t.begin(), t.end());
    const std::vector<glm::dvec2> hull = convex_hull(std::move(points));
    Rectangle best;
    double least = INFINITY;
    for (std::size_t i = 0; i < hull.size(); ++i) {
        glm::dvec2 x = hull[(i + 1) % hull.size()] - hull[i];
        if (!(glm::length(x) > 0)) continue;
        x = glm::normalize(x);
        const auto range = [&](const glm::dvec2& axis) {
            Range r{INFINITY, -INFINITY};
            for (const glm::dvec2& p : hull)
                r.low = std::min(r.low, glm::dot(p, axis)), r.high = std::max(r.high, glm::dot(p, axis));
            return r;
        };
        Rectangle rectangle{x, range(x), range({-x.y, x.x})};
        const double width = rectangle.range_x.high - rectangle.range_x.low;
        const double height = rectangle.range_y.high - rectangle.range_y.low;
        // A rounding error is no reason to turn a chart otherwise than its neighbour.
        if (!(width * height < least * (1 - 1e-9))) continue;
        least = width * height;
        if (width < height) {
            rectangle.x = {-x.y, x.x};
            rectangle.range_x = range(rectangle.x);
            rectangle.range_y = range(-x);
        }
        best = rectangle;
    }
    return best;
}

} // namespace

std::vector<bool> without_overlap(const std::vector<FlatTriangle>& triangles) {
    const std::size_t n = triangles.size();
    std::vector<std::uint32_t> order(n); // from left to right
    std::iota(order.begin(), order.end(), 0u);
    std::vector<Range> x, y;
    for (const FlatTriangle& t : triangles) x.push_back(along(t, {1, 0})), y.push_back(along(t, {0, 1}));
    std::stable_sort(order.begin(), order.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return x[a].low < x[b].low; });
    std::vector<std::vector<std::uint32_t>> conflicts(n); // of each with earlier ones
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = i + 1; j < n && x[order[j]].low < x[order[i]].high; ++j) {
            const auto [a, b] = std::minmax(order[i], order[j]);
            if (y[a].low < y[b].high && y[b].low < y[a].high && overlap(triangles[a], triangles[b]))
                conflicts[b].push_back(a);
        }
    std::vector<bool> keep(n, true);
    for (std::size_t i = 0; i < n; ++i)
        for (const std::uint32_t earlier : conflicts[i])
            if (keep[earlier]) keep[i] = false;
    return keep;
}

glm::dvec2 lay_into_smallest_rectangle(std::vector<FlatTriangle>& triangles) {
    const Rectangle r = smallest_rectangle(triangles);
    const glm::dvec2 y(-r.x.y, r.x.x);
    for (FlatTriangle& t : triangles)
        for (glm::dvec2& p : t) p = {glm::dot(p, r.x) - r.range_x.low, glm::dot(p, y) - r.range_y.low};
    return {r.range_x.high - r.range_x.low, r.range_y.high - r.range_y.low};
}

} // namespace ajar
