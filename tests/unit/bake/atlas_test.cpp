// Charts and their atlas: nothing overlaps, everything has texels, all at one density.
#include "bake/atlas.hpp"

#include "bake/packing.hpp"
#include "bake/texels.hpp"
#include "base/error.hpp"
#include "unit/bake/shapes.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <map>
#include <random>

namespace ajar::test {
namespace {

constexpr std::uint32_t SIDE = 256;

class OfAScene : public testing::TestWithParam<std::size_t> {
  protected:
    const Scene scene = awkward_scenes()[GetParam()].second;
    const Atlas atlas = make_atlas(make_charts(placed_triangles(scene)), SIDE);
    const std::vector<std::array<glm::dvec2, 3>>& corners = atlas.texel_corners;
};

double twice_area(const std::array<glm::dvec2, 3>& t) {
    const glm::dvec2 a = t[1] - t[0], b = t[2] - t[0];
    return a.x * b.y - a.y * b.x;
}

// Weights of a place in texels; all of one sign where it is inside.
glm::dvec3 barycentrics(const std::array<glm::dvec2, 3>& t, const glm::dvec2& p) {
    glm::dvec3 w;
    for (int k = 0; k < 3; ++k) {
        const auto i = static_cast<std::size_t>(k);
        w[k] = twice_area({p, t[(i + 1) % 3], t[(i + 2) % 3]}) / twice_area(t);
    }
    return w;
}

TEST_P(OfAScene, EveryTriangleWithAreaIsInOneChart) {
    const Charts& charts = atlas.charts;
    std::vector<int> seen(charts.triangles.size());
    for (std::uint32_t c = 0; c < charts.charts.size(); ++c)
        for (const std::uint32_t t : charts.charts[c].triangles) {
            ++seen[t];
            EXPECT_EQ(charts.chart_of[t], c);
            EXPECT_EQ(charts.triangles[t].instance, charts.triangles[charts.charts[c].triangles[0]].instance);
        }
    for (const int count : seen) EXPECT_EQ(count, 1);
    std::size_t all = 0;
    for (const Instance& instance : scene.instances) all += scene.meshes[instance.mesh].triangles.size();
    EXPECT_EQ(seen.size(), all);
}

// Sixteen points in each texel are counted: no two triangles hold the same one, but on their borders.
TEST_P(OfAScene, TrianglesDoNotOverlap) {
    std::map<std::pair<int, int>, std::uint32_t> owner;
    constexpr double FINE = 4;
    std::size_t held = 0;
    for (std::uint32_t t = 0; t < corners.size(); ++t) {
        const glm::dvec2 low = FINE * glm::min(corners[t][0], glm::min(corners[t][1], corners[t][2]));
        const glm::dvec2 high = FINE * glm::max(corners[t][0], glm::max(corners[t][1], corners[t][2]));
        for (int y = static_cast<int>(low.y); y <= static_cast<int>(high.y); ++y)
            for (int x = static_cast<int>(low.x); x <= static_cast<int>(high.x); ++x) {
                const glm::dvec2 p = glm::dvec2(x + 0.4567, y + 0.5432) / FINE;
                const glm::dvec3 w = barycentrics(corners[t], p);
                if (!(std::min({w.x, w.y, w.z}) > 1e-4)) continue;
                const auto [entry, is_new] = owner.emplace(std::pair(x, y), t);
                EXPECT_TRUE(is_new) << "triangles " << entry->second << " and " << t << " share " << p.x
                                    << ", " << p.y;
                ++held;
            }
    }
    EXPECT_GT(held, std::size_t{SIDE} * SIDE) << "a sixteenth of the atlas at least is in use";
}

// What a bilinear filter reads at any place of a triangle is the triangle's chart, gutter included, and no
// chart comes nearer to another, or to the border, than its gutter.
TEST_P(OfAScene, FiltersStayAmongAChartsOwnTexels) {
    std::vector<std::uint32_t> chart_at(std::size_t{SIDE} * SIDE, NO_INDEX);
    for (std::uint32_t c = 0; c < atlas.sizes.size(); ++c)
        for (std::uint32_t y = 0; y < atlas.sizes[c].y; ++y)
            for (std::uint32_t x = 0; x < atlas.sizes[c].x; ++x) {
                const glm::uvec2 p = atlas.places[c] + glm::uvec2(x, y);
                ASSERT_LT(std::max(p.x, p.y), SIDE);
                EXPECT_EQ(chart_at[p.x + SIDE * p.y], NO_INDEX) << "charts meet";
                chart_at[p.x + SIDE * p.y] = c;
            }
    for (std::uint32_t t = 0; t < corners.size(); ++t)
        for (const glm::dvec2& corner : corners[t]) {
            const std::uint32_t c = atlas.charts.chart_of[t];
            const glm::dvec2 inside = corner - glm::dvec2(atlas.places[c]);
            EXPECT_GE(std::min(inside.x, inside.y), GUTTER + 0.5 - 1e-6);
            const glm::dvec2 left = glm::dvec2(atlas.sizes[c]) - inside;
            EXPECT_GE(std::min(left.x, left.y), GUTTER + 0.5 - 1e-6);
        }
    for (const CoveredTexel& texel : covered_texels(atlas))
        EXPECT_EQ(chart_at[texel.texel], atlas.charts.chart_of[texel.triangle]);
}

// Seen from anywhere on a triangle, the four texels around are covered or next to one that is.
TEST_P(OfAScene, EveryPlaceHasTexels) {
    std::vector<bool> covered(std::size_t{SIDE} * SIDE);
    for (const CoveredTexel& texel : covered_texels(atlas)) covered[texel.texel] = true;
    std::mt19937 random(5);
    std::uniform_real_distribution<double> uniform;
    for (const auto& t : corners)
        for (int i = 0; i < 50; ++i) {
            const double a = std::sqrt(uniform(random)), b = uniform(random);
            const glm::dvec2 p = (1 - a) * t[0] + a * (1 - b) * t[1] + a * b * t[2];
            EXPECT_TRUE(covered[static_cast<std::size_t>(p.x) + SIDE * static_cast<std::size_t>(p.y)]);
        }
}

// A texel's piece, put where its triangle lies in the atlas, is its square within its chart.
TEST_P(OfAScene, APieceIsItsTexel) {
    for (const CoveredTexel& texel : covered_texels(atlas)) {
        const auto& t = corners[texel.triangle];
        const auto place = [&](const glm::vec2& uv) {
            const glm::dvec2 w(uv);
            return t[0] + w.x * (t[1] - t[0]) + w.y * (t[2] - t[0]);
        };
        const std::uint32_t chart = atlas.charts.chart_of[texel.triangle];
        const glm::dvec2 first = glm::dvec2(atlas.places[chart]) + (GUTTER + 0.5);
        const glm::dvec2 last = glm::dvec2(atlas.places[chart] + atlas.sizes[chart]) - (GUTTER + 0.5);
        const glm::dvec2 corner(texel.texel % SIDE, texel.texel / SIDE);
        const glm::dvec2 low = glm::max(corner, first), high = glm::min(corner + 1.0, last);
        if (std::abs(twice_area(t)) < 1e-3) { // too small for floats to say: it is somewhere in the square
            EXPECT_LT(glm::length(place(texel.origin) - corner), 4.0);
            continue;
        }
        EXPECT_LT(glm::length(place(texel.origin) - low), 1e-2);
        EXPECT_LT(glm::length(place(texel.origin + texel.edge_x + texel.edge_y) - high), 1e-2);
        EXPECT_LT(glm::length(place(texel.origin + texel.edge_x) - glm::dvec2(high.x, low.y)), 1e-2);
    }
}

// Area in texels against area in metres: never below the density that the atlas says, but for what turns a
// triangle out of its chart's plane; above it only where a chart is so small that whole texels are coarse.
TEST_P(OfAScene, DensityIsTheSameEverywhere) {
    const double density = atlas.texels_per_metre * atlas.texels_per_metre;
    for (std::uint32_t t = 0; t < corners.size(); ++t) {
        const PlacedTriangle& placed = atlas.charts.triangles[t];
        const double area = glm::length(
            glm::cross(placed.corners[1] - placed.corners[0], placed.corners[2] - placed.corners[0]));
        const double ratio = std::abs(twice_area(corners[t])) / (area * density);
        const glm::dvec2 texels(atlas.sizes[atlas.charts.chart_of[t]] - 1u - 2 * GUTTER);
        EXPECT_GT(ratio, std::cos(CHART_ANGLE) * (1 - 1e-5));
        if (std::min(texels.x, texels.y) >= 2) {
            EXPECT_LT(ratio, texels.x / (texels.x - 1) * (texels.y / (texels.y - 1)) + 1e-5);
        }
    }
}

TEST_P(OfAScene, TheSameSceneGivesTheSameAtlas) {
    const Atlas again = make_atlas(make_charts(placed_triangles(scene)), SIDE);
    EXPECT_EQ(again.texel_corners, corners);
    EXPECT_EQ(again.places, atlas.places);
}

INSTANTIATE_TEST_SUITE_P(Atlas, OfAScene, testing::Range(std::size_t{0}, awkward_scenes().size()),
                         [](const auto& info) { return awkward_scenes()[info.param].first; });

TEST(Charts, AFlatWallIsOne) {
    SceneBuilder builder;
    builder.room({0, 0, 0}, {1, 2, 3}, builder.material(lambert({1, 1, 1})));
    const Charts charts = make_charts(placed_triangles(builder.build()));
    ASSERT_EQ(charts.charts.size(), 6u);
    for (const Chart& chart : charts.charts) EXPECT_EQ(chart.triangles.size(), 2u);
    EXPECT_NEAR(charts.charts[0].extent.x, 3, 1e-9);
    EXPECT_NEAR(charts.charts[0].extent.y, 2, 1e-9);
}

TEST(Charts, TrianglesWithoutAreaAreLeftOut) {
    Scene scene = awkward_scenes()[0].second;
    const std::size_t before = placed_triangles(scene).size();
    scene.meshes[0].triangles.emplace_back(0, 1, 1);
    scene.meshes[0].triangle_materials.push_back(0);
    EXPECT_EQ(placed_triangles(scene).size(), before);
}

TEST(Atlas, TooSmallForItsChartsIsAnError) {
    try {
        make_atlas(make_charts(placed_triangles(awkward_scenes()[4].second)), 64);
        FAIL() << "200 triangles of 7 x 7 texels have no place in 64 x 64";
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("too small for 200 charts"), std::string::npos)
            << error.what();
    }
}

TEST(Packing, FillsASquareThatFitsExactly) {
    const std::vector<glm::uvec2> sizes{{4, 4}, {4, 4}, {8, 2}, {2, 2}, {2, 2}, {4, 2}};
    const auto places = pack(sizes, 8);
    ASSERT_TRUE(places);
    std::vector<int> count(64);
    for (std::size_t i = 0; i < sizes.size(); ++i)
        for (std::uint32_t y = 0; y < sizes[i].y; ++y)
            for (std::uint32_t x = 0; x < sizes[i].x; ++x)
                ++count[(*places)[i].x + x + 8 * ((*places)[i].y + y)];
    EXPECT_EQ(count, std::vector<int>(64, 1));
    EXPECT_FALSE(pack(std::vector<glm::uvec2>{{9, 1}}, 8));
    EXPECT_FALSE(pack(std::vector<glm::uvec2>{{8, 5}, {8, 4}}, 8));
}

TEST(Gutter, FillsEverythingFromTheNearest) {
    constexpr std::uint32_t side = 16;
    std::vector<glm::vec4> values(side * side, glm::vec4(-1));
    std::vector<bool> has_value(side * side);
    for (std::uint32_t y = 4; y < 8; ++y)
        for (std::uint32_t x = 3; x < 9; ++x)
            values[x + side * y] = glm::vec4(x, 2, 3, 1), has_value[x + side * y] = true;
    fill_gutter(values, has_value, side);
    for (std::uint32_t i = 0; i < side * side; ++i) {
        if (has_value[i]) {
            EXPECT_EQ(values[i], glm::vec4(static_cast<float>(i % side), 2, 3, 1)); // as it was
        }
        EXPECT_GE(values[i].x, 3);
        EXPECT_LE(values[i].x, 8);
        EXPECT_NEAR(values[i].y, 2, 1e-6f);
    }
    EXPECT_EQ(values[2 + side * 5].x, 3); // all its neighbours with values are in the first column
}

TEST(Gutter, OfNothingIsNothing) {
    std::vector<glm::vec4> values(4, glm::vec4(7));
    fill_gutter(values, std::vector<bool>(4), 2);
    EXPECT_EQ(values[0], glm::vec4(7));
}

} // namespace
} // namespace ajar::test
