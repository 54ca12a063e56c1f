// Corners' values join where surfaces are smooth, part at creases, and keep the integral.
#include "radiosity/smooth_vertices.hpp"

#include "support/scene_builder.hpp"

#include <gtest/gtest.h>
#include <map>
#include <random>
#include <set>

namespace ajar::test {
namespace {

std::vector<std::uint8_t> fronts(const PatchMesh& mesh) {
    std::vector<std::uint8_t> active(2 * mesh.patches.size());
    for (std::size_t side = 0; side < active.size(); side += 2) active[side] = 1;
    return active;
}

// Smooth vertices of the fronts at each position.
std::map<std::uint32_t, std::set<std::uint32_t>> front_vertices(const PatchMesh& mesh,
                                                                const SmoothVertices& smooth) {
    std::map<std::uint32_t, std::set<std::uint32_t>> found;
    for (std::uint32_t p = 0; p < mesh.patches.size(); ++p)
        for (std::uint32_t k = 0; k < 3; ++k) {
            const std::uint32_t vertex = smooth.vertex(2 * p, k);
            EXPECT_EQ(smooth.positions()[vertex], mesh.patches[p].vertices[k]);
            found[mesh.patches[p].vertices[k]].insert(vertex);
        }
    return found;
}

int walls_at(const glm::vec3& p) {
    int walls = 0;
    for (int axis = 0; axis < 3; ++axis) walls += std::abs(p[axis]) == 1;
    return walls;
}

Scene cube_room() {
    SceneBuilder builder;
    builder.room({-1, -1, -1}, {1, 1, 1}, builder.material(lambert(glm::vec3(0.5f))));
    return builder.build();
}

TEST(SmoothVertices, PartAtARoomsEdges) {
    const PatchMesh mesh = PatchMesh::subdivide(cube_room(), {0, 500});
    const SmoothVertices smooth(mesh);
    for (const auto& [vertex, smooth_vertices] : front_vertices(mesh, smooth))
        EXPECT_EQ(smooth_vertices.size(), static_cast<std::size_t>(walls_at(mesh.positions[vertex])));
    for (std::uint32_t p = 0; p < mesh.patches.size(); ++p)
        for (std::uint32_t k = 0; k < 3; ++k)
            EXPECT_NE(smooth.vertex(2 * p, k), smooth.vertex(2 * p + 1, k))
                << "a side has to do with its back";
}

TEST(SmoothVertices, JoinAroundASphere) {
    SceneBuilder builder;
    builder.sphere({0, 0, 0}, 1, 2, Normals::flat, builder.material(lambert(glm::vec3(0.5f))));
    const PatchMesh mesh = PatchMesh::subdivide(builder.build(), {0, 1});
    const SmoothVertices smooth(mesh);
    EXPECT_EQ(smooth.count(), 2 * mesh.positions.size()) << "one outside, one inside";
    for (const auto& [vertex, smooth_vertices] : front_vertices(mesh, smooth))
        EXPECT_EQ(smooth_vertices.size(), 1u);
    EXPECT_EQ(SmoothVertices(mesh, 0.05f).count(), 6 * mesh.patches.size()) << "every facet for itself";
}

TEST(SmoothVertices, JoinTrianglesThatFaceDifferentWays) {
    SceneBuilder builder; // one sheet, the halves of which turn their fronts to opposite sides
    const std::uint32_t grey = builder.material(lambert(glm::vec3(0.5f)));
    builder.quad({0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, grey);
    builder.quad({1, 0, 0}, {1, 1, 0}, {2, 1, 0}, {2, 0, 0}, grey);
    const PatchMesh mesh = PatchMesh::subdivide(builder.build(), {0, 1});
    const SmoothVertices smooth(mesh);
    EXPECT_EQ(smooth.count(), 2 * mesh.positions.size());
    // What both quads share: the front of one is the back of the other.
    const auto shared_vertices = [&](std::uint32_t side_a, std::uint32_t side_b) {
        std::set<std::uint32_t> a, b, both;
        for (const auto& [side, quad, set] : {std::tuple(side_a, 0u, &a), std::tuple(side_b, 1u, &b)})
            for (std::uint32_t p = 2 * quad; p < 2 * quad + 2; ++p)
                for (std::uint32_t k = 0; k < 3; ++k) set->insert(smooth.vertex(2 * p + side, k));
        std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::inserter(both, both.end()));
        return both.size();
    };
    EXPECT_EQ(shared_vertices(0, 0), 0u);
    EXPECT_EQ(shared_vertices(0, 1), 2u);
}

TEST(SmoothVertices, KeepTheIntegral) {
    PatchMesh mesh = PatchMesh::subdivide(cube_room(), {0, 300});
    std::mt19937 random(1);
    std::vector<std::uint8_t> marked(mesh.patches.size());
    for (std::uint8_t& mark : marked) mark = random() % 4 == 0;
    mesh.refine(marked); // patches of several sizes
    std::uniform_real_distribution<float> unit(0, 1);
    std::vector<glm::vec3> values(2 * mesh.patches.size());
    for (glm::vec3& value : values) value = {unit(random), unit(random), unit(random)};
    const SmoothVertices smooth(mesh);
    const std::vector<glm::vec3> means = smooth.mean(mesh, values, fronts(mesh));
    glm::dvec3 of_patches(0), of_corners(0);
    for (std::uint32_t p = 0; p < mesh.patches.size(); ++p) {
        of_patches += double{mesh.patches[p].area} * glm::dvec3(values[2 * p]);
        for (std::uint32_t k = 0; k < 3; ++k)
            of_corners += mesh.patches[p].area / 3.0 * glm::dvec3(means[smooth.vertex(2 * p, k)]);
    }
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(of_corners[c] / of_patches[c], 1, 1e-6);
}

TEST(SmoothVertices, LeaveOutSidesThatNobodySees) {
    const PatchMesh mesh = PatchMesh::subdivide(cube_room(), {0, 100});
    std::vector<glm::vec3> values(2 * mesh.patches.size(), glm::vec3(3));
    std::vector<std::uint8_t> active = fronts(mesh);
    active[0] = 0;
    values[0] = glm::vec3(1000);
    const SmoothVertices smooth(mesh);
    const std::vector<glm::vec3> means = smooth.mean(mesh, values, active);
    for (std::uint32_t p = 1; p < mesh.patches.size(); ++p)
        for (std::uint32_t k = 0; k < 3; ++k) {
            EXPECT_NEAR(means[smooth.vertex(2 * p, k)].x, 3, 1e-6f);
            EXPECT_EQ(means[smooth.vertex(2 * p + 1, k)], glm::vec3(0));
        }
}

} // namespace
} // namespace ajar::test
