#include "bake/texels.hpp"

#include <algorithm>
#include <cmath>

namespace ajar {

namespace {

double cross(const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; }

double squared_distance(const glm::dvec2& p, const glm::dvec2& a, const glm::dvec2& b) {
    const glm::dvec2 along = b - a;
    const double t = std::clamp(glm::dot(p - a, along) / glm::dot(along, along), 0.0, 1.0);
    const glm::dvec2 d = p - a - t * along;
    return glm::dot(d, d);
}

// A triangle in texels, counter-clockwise or not.
class TexelTriangle {
  public:
    explicit TexelTriangle(const std::array<glm::dvec2, 3>& corners)
        : c_(corners), twice_area_(cross(corners[1] - corners[0], corners[2] - corners[0])) {}

    // Apart if it is along an axis, which the box around it has seen to, or along an edge's normal.
    bool touches_texel(const glm::dvec2& middle) const {
        for (std::size_t k = 0; k < 3; ++k) {
            const glm::dvec2 edge = c_[(k + 1) % 3] - c_[k];
            const double inside = (twice_area_ < 0 ? -1 : 1) * cross(edge, middle - c_[k]);
            if (inside < -0.5 * (std::abs(edge.x) + std::abs(edge.y))) return false;
        }
        return true;
    }

    double squared_distance_to(const glm::dvec2& p) const {
        bool inside = true;
        double least = INFINITY;
        for (std::size_t k = 0; k < 3; ++k) {
            const glm::dvec2 &a = c_[k], &b = c_[(k + 1) % 3];
            inside = inside && cross(b - a, p - a) * twice_area_ >= 0;
            least = std::min(least, squared_distance(p, a, b));
        }
        return inside ? 0 : least;
    }

    // A rectangle in barycentrics. Of a triangle that is a speck within it, whose edges would be huge, the
    // middle.
    CoveredTexel covered(const glm::dvec2& low, const glm::dvec2& high) const {
        constexpr double SPECK = 1e-6; // texels squared
        if (std::abs(twice_area_) < SPECK) return {0, 0, glm::vec2(1.0f / 3), {}, {}};
        return {0, 0, barycentrics(low - c_[0]), barycentrics({high.x - low.x, 0}),
                barycentrics({0, high.y - low.y})};
    }

    glm::dvec2 lower() const { return glm::floor(glm::min(c_[0], glm::min(c_[1], c_[2]))); }
    glm::dvec2 upper() const { return glm::floor(glm::max(c_[0], glm::max(c_[1], c_[2]))); }

  private:
    // Of a direction; of a place relative to the first corner.
    glm::vec2 barycentrics(const glm::dvec2& d) const {
        return glm::dvec2(cross(d, c_[2] - c_[0]), cross(c_[1] - c_[0], d)) / twice_area_;
    }

    std::array<glm::dvec2, 3> c_;
    double twice_area_;
};

} // namespace

std::vector<CoveredTexel> covered_texels(const Atlas& atlas) {
    constexpr std::uint32_t NOBODY = 0xffffffffu;
    const std::size_t count = std::size_t{atlas.side} * atlas.side;
    std::vector<std::uint32_t> owner(count, NOBODY);
    std::vector<double> distance(count, INFINITY);
    for (std::uint32_t t = 0; t < atlas.texel_corners.size(); ++t) {
        const TexelTriangle triangle(atlas.texel_corners[t]);
        for (double y = triangle.lower().y; y <= triangle.upper().y; ++y)
            for (double x = triangle.lower().x; x <= triangle.upper().x; ++x) {
                const glm::dvec2 middle(x + 0.5, y + 0.5);
                const auto texel = static_cast<std::size_t>(y) * atlas.side + static_cast<std::size_t>(x);
                if (!triangle.touches_texel(middle)) continue;
                const double d = triangle.squared_distance_to(middle);
                if (d < distance[texel]) distance[texel] = d, owner[texel] = t;
            }
    }
    std::vector<CoveredTexel> result;
    for (std::uint32_t texel = 0; texel < count; ++texel) {
        if (owner[texel] == NOBODY) continue;
        const std::uint32_t chart = atlas.charts.chart_of[owner[texel]];
        const glm::dvec2 first = glm::dvec2(atlas.places[chart] + GUTTER) + 0.5;
        const glm::dvec2 last = first + glm::dvec2(atlas.sizes[chart] - 1u - 2 * GUTTER);
        const glm::dvec2 corner(texel % atlas.side, texel / atlas.side);
        CoveredTexel& covered =
            result.emplace_back(TexelTriangle(atlas.texel_corners[owner[texel]])
                                    .covered(glm::max(corner, first), glm::min(corner + 1.0, last)));
        covered.texel = texel;
        covered.triangle = owner[texel];
    }
    return result;
}

void fill_gutter(std::vector<glm::vec4>& values, std::vector<bool> has_value, std::uint32_t side) {
    const auto neighbours = [side](std::uint32_t texel, auto&& visit) {
        const auto x = static_cast<std::int64_t>(texel % side), y = static_cast<std::int64_t>(texel / side);
        for (std::int64_t j = std::max<std::int64_t>(y - 1, 0); j <= std::min<std::int64_t>(y + 1, side - 1);
             ++j)
            for (std::int64_t i = std::max<std::int64_t>(x - 1, 0);
                 i <= std::min<std::int64_t>(x + 1, side - 1); ++i)
                if (i != x || j != y) visit(static_cast<std::uint32_t>(i + side * j));
    };
    std::vector<bool> is_listed = has_value;
    std::vector<std::uint32_t> ring;
    const auto list_around = [&](std::uint32_t texel) {
        neighbours(texel, [&](std::uint32_t other) {
            if (is_listed[other]) return;
            is_listed[other] = true;
            ring.push_back(other);
        });
    };
    for (std::uint32_t texel = 0; texel < values.size(); ++texel)
        if (has_value[texel]) list_around(texel);
    while (!ring.empty()) {
        for (const std::uint32_t texel : ring) {
            glm::vec4 sum(0);
            float count = 0;
            neighbours(texel, [&](std::uint32_t other) {
                if (has_value[other]) sum += values[other], ++count;
            });
            values[texel] = sum / count;
        }
        const std::vector<std::uint32_t> done = std::move(ring);
        ring.clear();
        for (const std::uint32_t texel : done) has_value[texel] = true; // not earlier: a ring sees the last
        for (const std::uint32_t texel : done) list_around(texel);
    }
}

} // namespace ajar
