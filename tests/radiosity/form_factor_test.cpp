// Rows of form factors against closed forms, where nothing is in the way (catalogued by Howell, "A Catalog of
// Radiation Heat Transfer Configuration Factors": C-11, C-14, C-41; and the inside of a sphere).
#include "radiosity/form_factors.hpp"
#include "radiosity/reciprocity.hpp"
#include "radiosity_test.hpp"
#include "support/lambert.hpp"

#include <cmath>
#include <glm/gtc/constants.hpp>

namespace ajar::test {
namespace {

constexpr double PI = glm::pi<double>();
constexpr std::uint32_t RAYS = 16384;

// Rows of the sides that are asked for, and of what they meet.
class Rows {
  public:
    Rows(const gpu::Device& device, const Scene& scene, std::uint32_t patches, std::uint32_t rays,
         std::uint64_t memory_bytes = std::uint64_t{1} << 30)
        : mesh(PatchMesh::subdivide(scene, {0, patches})),
          gpu_scene_(device, scene, GpuSceneOptions{.bake_below_triangles = UINT64_MAX}),
          rig(device, scene, gpu_scene_, mesh, settings_, rays), factors(rig, rays, memory_bytes) {}

    void trace_fronts() {
        std::vector<std::uint32_t> sides;
        for (std::uint32_t p = 0; p < mesh.patches.size(); ++p) sides.push_back(2 * p);
        trace(sides);
    }
    void trace(const std::vector<std::uint32_t>& sides) {
        ASSERT_TRUE(factors.trace(sides, [](std::uint32_t, std::uint32_t) { return true; }));
        row_of_.assign(rig.side_count(), NO_INDEX);
        for (std::uint32_t row = 0; row < factors.row_count(); ++row) row_of_[factors.row_sides()[row]] = row;
    }
    std::vector<std::uint32_t> entries(std::uint32_t side) { return factors.entries(row_of_[side]); }
    std::uint32_t instance(std::uint32_t side) const {
        return mesh.sources[mesh.patches[side / 2].source].instance;
    }

    // From one instance's fronts to another's.
    double between(std::uint32_t from, std::uint32_t to) {
        double met = 0;
        double area = 0;
        for (std::uint32_t side = 0; side < rig.side_count(); side += 2) {
            if (instance(side) != from) continue;
            double count = 0;
            for (const std::uint32_t entry : entries(side))
                count += entry < rig.side_count() && entry % 2 == 0 && instance(entry) == to;
            area += mesh.patches[side / 2].area;
            met += mesh.patches[side / 2].area * count / factors.rays();
        }
        return met / area;
    }

    const PatchMesh mesh;

  private:
    const RenderSettings settings_{};
    GpuScene gpu_scene_;

  public:
    RadiosityRig rig;
    FormFactors factors;

  private:
    std::vector<std::uint32_t> row_of_;
};

class FormFactor : public RadiosityTest {
  protected:
    // Within 1 %, or three standard deviations of so many rays if they were independent.
    static void expect_factor(double found, double right, double rays) {
        EXPECT_NEAR(found, right, std::max(0.01 * right, 3 * std::sqrt(right * (1 - right) / rays)));
    }
};

// A regular polygon of many corners in the plane y = height, facing up or down.
void add_disk(SceneBuilder& builder, float radius, float height, bool up, std::uint32_t material) {
    constexpr int CORNERS = 512;
    const auto corner = [&](int k) {
        const double angle = 2 * PI * (up ? -k : k) / CORNERS;
        return glm::vec3(radius * std::cos(angle), height, radius * std::sin(angle));
    };
    for (int k = 0; k < CORNERS; k += 2)
        builder.quad({0, height, 0}, corner(k), corner(k + 1), corner(k + 2), material);
}

TEST_F(FormFactor, OfParallelSquares) {
    for (const double distance : {0.5, 1.0, 3.0}) {
        SceneBuilder builder;
        const std::uint32_t grey = builder.material(lambert({0.5f, 0.5f, 0.5f}));
        builder.square({0, 0, 0}, {0, 1, 0}, 0.5f, grey);
        builder.square({0, static_cast<float>(distance), 0}, {0, -1, 0}, 0.5f, grey);
        const double x = 1 / distance;
        const double s = std::sqrt(1 + x * x);
        const double right = 2 / (PI * x * x) *
                             (std::log(s * s / std::sqrt(1 + 2 * x * x)) + 2 * x * s * std::atan(x / s) -
                              2 * x * std::atan(x));
        Rows rows(device(), builder.build(), 1, RAYS);
        rows.trace_fronts();
        expect_factor(rows.between(0, 1), right, 2 * RAYS);
        expect_factor(rows.between(1, 0), right, 2 * RAYS);
    }
}

// C-14: a rectangle of width w and one of height h at right angles along an edge of length 1.
double perpendicular_factor(double w, double h) {
    const double w2 = w * w;
    const double h2 = h * h;
    const double logarithm = std::log((1 + w2) * (1 + h2) / (1 + w2 + h2)) +
                             w2 * std::log(w2 * (1 + w2 + h2) / ((1 + w2) * (w2 + h2))) +
                             h2 * std::log(h2 * (1 + w2 + h2) / ((1 + h2) * (w2 + h2)));
    const double diagonal = std::sqrt(h2 + w2);
    return (w * std::atan(1 / w) + h * std::atan(1 / h) - diagonal * std::atan(1 / diagonal) +
            0.25 * logarithm) /
           (PI * w);
}

TEST_F(FormFactor, OfPerpendicularRectanglesWithACommonEdge) {
    EXPECT_NEAR(perpendicular_factor(1, 1), 0.20004, 1e-5); // two walls of a cube
    for (const float height : {0.25f, 1.0f, 2.0f}) {
        SceneBuilder builder;
        const std::uint32_t grey = builder.material(lambert({0.5f, 0.5f, 0.5f}));
        builder.quad({0, 0, 0}, {0, 0, 1}, {1, 0, 1}, {1, 0, 0}, grey);
        builder.quad({0, 0, 0}, {0, height, 0}, {0, height, 1}, {0, 0, 1}, grey);
        Rows rows(device(), builder.build(), 1, RAYS);
        rows.trace_fronts();
        expect_factor(rows.between(0, 1), perpendicular_factor(1, height), 2 * RAYS);
        expect_factor(rows.between(1, 0), perpendicular_factor(1, height) / height, 2 * RAYS);
    }
}

TEST_F(FormFactor, OfCoaxialDisks) {
    for (const float radius : {0.5f, 1.0f, 2.0f}) {
        SceneBuilder builder;
        const std::uint32_t grey = builder.material(lambert({0.5f, 0.5f, 0.5f}));
        add_disk(builder, 1, 0, true, grey);
        const auto first_above = static_cast<std::uint32_t>(builder.build().instances.size());
        add_disk(builder, radius, 0.8f, false, grey);
        const double r1 = 1 / 0.8;
        const double r2 = radius / 0.8;
        const double s = 1 + (1 + r2 * r2) / (r1 * r1);
        const double right = 0.5 * (s - std::sqrt(s * s - 4 * r2 * r2 / (r1 * r1)));
        Rows rows(device(), builder.build(), 1, 64);
        rows.trace_fronts();
        double met = 0;
        double count = 0;
        for (std::uint32_t side = 0; side < rows.rig.side_count(); side += 2) {
            if (rows.instance(side) >= first_above) continue;
            for (const std::uint32_t entry : rows.entries(side)) {
                met += entry < rows.rig.side_count() && rows.instance(entry) >= first_above;
                ++count;
            }
        }
        expect_factor(met / count, right, count); // wedges of one area
    }
}

TEST_F(FormFactor, OfASmallPatchToARectangleIsLambertsFormula) {
    SceneBuilder builder;
    const std::uint32_t grey = builder.material(lambert({0.5f, 0.5f, 0.5f}));
    builder.square({0.3f, 0, 0.1f}, {0, 1, 0}, 1e-3f, grey);
    builder.square({0, 1, 0}, {0, -1, 0}, 1, grey);
    const std::vector<glm::dvec3> corners = {{-1, 1, -1}, {1, 1, -1}, {1, 1, 1}, {-1, 1, 1}};
    Rows rows(device(), builder.build(), 1, RAYS);
    rows.trace_fronts();
    expect_factor(rows.between(0, 1), polygon_irradiance(corners, {0.3, 0, 0.1}, {0, 1, 0}) / PI, 2 * RAYS);
}

TEST_F(FormFactor, InsideASphereIsAShareOfItsArea) {
    // F_ij = A_j / (4 pi r^2), wherever i and j are: from a few facets to all that lie in each octant.
    SceneBuilder builder;
    builder.sphere({0, 0, 0}, 1, 3, Normals::flat, builder.material(lambert({0.5f, 0.5f, 0.5f})));
    constexpr std::uint32_t FEWER_RAYS = 4096;
    Rows rows(device(), builder.build(), 1, FEWER_RAYS);
    const auto octant = [&](std::uint32_t side) {
        glm::vec3 middle(0);
        for (const std::uint32_t v : rows.mesh.patches[side / 2].vertices) middle += rows.mesh.positions[v];
        return (middle.x > 0 ? 1u : 0u) | (middle.y > 0 ? 2u : 0u) | (middle.z > 0 ? 4u : 0u);
    };
    double areas[8] = {};
    double all = 0;
    for (std::uint32_t p = 0; p < rows.mesh.patches.size(); ++p) {
        areas[octant(2 * p)] += rows.mesh.patches[p].area;
        all += rows.mesh.patches[p].area;
    }
    rows.trace({1, 401, 1001, 2001}); // backs: facets face outwards
    EXPECT_EQ(rows.factors.row_count(), rows.mesh.patches.size()) << "all backs are met, no front is";
    for (const std::uint32_t side : {1u, 401u, 1001u, 2001u}) {
        double met[8] = {};
        for (const std::uint32_t entry : rows.entries(side)) {
            ASSERT_LT(entry, rows.rig.side_count()) << "a ray left the sphere";
            met[octant(entry)] += 1;
        }
        for (int k = 0; k < 8; ++k) expect_factor(met[k] / FEWER_RAYS, areas[k] / all, FEWER_RAYS);
    }
}

TEST_F(FormFactor, RowsOfAClosedRoomSumToOneAndOfAnOpenOneToLess) {
    Rows room(device(), small_cornell_box(), 400, 64);
    room.trace_fronts();
    EXPECT_GT(room.factors.sky_share(), 0.05) << "the box has no front wall";
    EXPECT_EQ(room.factors.nowhere_share(), 0);
    Rows closed(device(), furnace_room({0.5f, 0.5f, 0.5f}, {1, 1, 1}), 400, 64);
    closed.trace_fronts();
    for (std::uint32_t row = 0; row < closed.factors.row_count(); ++row)
        for (const std::uint32_t entry : closed.factors.entries(row)) {
            EXPECT_LT(entry, closed.rig.side_count());
            EXPECT_EQ(entry % 2, 0u) << "a wall's back was met from inside";
            EXPECT_NE(entry, closed.factors.row_sides()[row]) << "a patch sees itself";
        }
}

TEST_F(FormFactor, ReciprocityHoldsUpToTheNoiseOfTheRays) {
    Rows rows(device(), small_cornell_box(), 200, 1024);
    rows.trace_fronts();
    const Reciprocity r = measure_reciprocity(rows.rig, rows.factors, 1000);
    EXPECT_GT(r.pairs, 100u);
    // The mean of 100 squares of normal variables exceeds 1.6 once in 10,000; stratified ones are smaller.
    EXPECT_LT(r.rms, 1.27 * r.expected);
    EXPECT_GT(r.rms, 0) << "noise has to show";
    EXPECT_GE(r.max, r.rms);
}

TEST_F(FormFactor, ARowIsTheSameWhereverItIsKept) {
    Rows stored(device(), small_cornell_box(), 300, 64);
    Rows none(device(), small_cornell_box(), 300, 64, 0);
    Rows some(device(), small_cornell_box(), 300, 64, 100 * 64 * 4);
    for (Rows* rows : {&stored, &none, &some}) rows->trace_fronts();
    EXPECT_EQ(stored.factors.stored_rows(), stored.factors.row_count());
    EXPECT_EQ(none.factors.stored_rows(), 0u);
    EXPECT_EQ(some.factors.stored_rows(), 100u);
    ASSERT_EQ(stored.factors.row_sides(), none.factors.row_sides());
    for (std::uint32_t row = 0; row < stored.factors.row_count(); row += 7) {
        EXPECT_EQ(stored.factors.entries(row), none.factors.entries(row));
        EXPECT_EQ(stored.factors.entries(row), some.factors.entries(row));
    }
}

} // namespace
} // namespace ajar::test
