// Patches tile the scene's triangles, join without cracks, and are found from barycentrics.
#include "radiosity/patch_mesh.hpp"

#include "base/error.hpp"
#include "support/scene_builder.hpp"

#include <cstring>
#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>
#include <map>
#include <random>
#include <set>

namespace ajar::test {
namespace {

using Key = std::tuple<float, float, float>;
Key key(const glm::vec3& p) { return {p.x, p.y, p.z}; }

glm::vec3 mirrored_by(const glm::mat4& m, const glm::vec3& p) { return glm::vec3(m * glm::vec4(p, 1)); }

// A closed room with a box in it, a sphere, and slivers; the sphere's mesh placed twice more, once mirrored.
Scene varied_scene() {
    SceneBuilder builder;
    const std::uint32_t grey = builder.material(lambert(glm::vec3(0.5f)));
    builder.room({-2, 0, -2}, {2, 3, 3}, grey);
    builder.box({-0.7f, 0.1f, -0.9f}, {0.1f, 1.3f, 0.2f}, grey);
    builder.sphere({1, 1, 1}, 0.4f, 1, Normals::smooth, grey);
    builder.quad({-1, 1, 2}, {1.3f, 1, 2}, {1.3f, 1.01f, 2}, {-1, 1.01f, 2}, grey);
    Scene scene = builder.build();
    const std::uint32_t sphere = scene.instances[2].mesh;
    for (const float mirror : {1.0f, -1.0f}) {
        Instance instance;
        instance.mesh = sphere;
        instance.to_world = glm::scale(glm::translate(glm::mat4(1), {mirror, 0.3f, -0.2f}),
                                       glm::vec3(mirror * 0.5f, 1.1f, 0.7f));
        scene.instances.push_back(instance);
    }
    return scene;
}

double scene_area(const Scene& scene) {
    double area = 0;
    for (const Instance& i : scene.instances)
        for (const glm::uvec3& t : scene.meshes[i.mesh].triangles) {
            const auto at = [&](int k) {
                return glm::dvec3(mirrored_by(i.to_world, scene.meshes[i.mesh].positions[t[k]]));
            };
            area += 0.5 * glm::length(glm::cross(at(1) - at(0), at(2) - at(0)));
        }
    return area;
}

double mesh_area(const PatchMesh& mesh) {
    double area = 0;
    for (const Patch& patch : mesh.patches) area += patch.area;
    return area;
}

double longest_edge(const PatchMesh& mesh) {
    double longest = 0;
    for (const Patch& patch : mesh.patches)
        for (int k = 0; k < 3; ++k)
            longest =
                std::max(longest, glm::distance(glm::dvec3(mesh.positions[patch.vertices[k]]),
                                                glm::dvec3(mesh.positions[patch.vertices[(k + 1) % 3]])));
    return longest;
}

// How many patches share each edge.
std::map<std::pair<std::uint32_t, std::uint32_t>, int> edge_uses(const PatchMesh& mesh) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> uses;
    for (const Patch& patch : mesh.patches)
        for (int k = 0; k < 3; ++k) ++uses[std::minmax(patch.vertices[k], patch.vertices[(k + 1) % 3])];
    return uses;
}

void expect_no_vertex_in_an_edge(const PatchMesh& mesh) {
    std::set<Key> vertices;
    for (const glm::vec3& p : mesh.positions)
        EXPECT_TRUE(vertices.insert(key(p)).second) << "a position stored twice";
    for (const auto& [edge, uses] : edge_uses(mesh)) {
        const glm::vec3 middle = 0.5f * mesh.positions[edge.first] + 0.5f * mesh.positions[edge.second];
        ASSERT_FALSE(vertices.contains(key(middle))) << "a crack";
    }
}

// Barycentrics of (u, v) within the patch, in double.
glm::dvec3 within(const Patch& patch, double u, double v) {
    const glm::dvec2 a(patch.corners[0]);
    const glm::dvec2 e = glm::dvec2(patch.corners[1]) - a;
    const glm::dvec2 f = glm::dvec2(patch.corners[2]) - a;
    const glm::dvec2 d = glm::dvec2(u, v) - a;
    const double determinant = e.x * f.y - e.y * f.x;
    const double s = (d.x * f.y - d.y * f.x) / determinant;
    const double t = (e.x * d.y - e.y * d.x) / determinant;
    return {1 - s - t, s, t};
}

void expect_consistent(const Scene& scene, const PatchMesh& mesh) {
    std::vector<double> barycentric_area(mesh.sources.size());
    for (const Patch& patch : mesh.patches) {
        const PatchSource& source = mesh.sources[patch.source];
        const Instance& instance = scene.instances[source.instance];
        const Mesh& shape = scene.meshes[instance.mesh];
        const glm::uvec3 t = PatchMesh::mesh_triangle(scene, source);
        glm::dvec3 p[3];
        for (int k = 0; k < 3; ++k) p[k] = mirrored_by(instance.to_world, shape.positions[t[k]]);
        for (int k = 0; k < 3; ++k) {
            const glm::dvec2 c(patch.corners[k]);
            const glm::dvec3 expected = (1 - c.x - c.y) * p[0] + c.x * p[1] + c.y * p[2];
            ASSERT_LT(glm::distance(expected, glm::dvec3(mesh.positions[patch.vertices[k]])), 1e-5);
        }
        const glm::dvec3 cross = glm::cross(p[1] - p[0], p[2] - p[0]);
        ASSERT_LT(glm::distance(glm::normalize(cross), glm::dvec3(patch.normal)), 1e-6);
        const glm::dvec2 e(patch.corners[1] - patch.corners[0]);
        const glm::dvec2 f(patch.corners[2] - patch.corners[0]);
        barycentric_area[patch.source] += e.x * f.y - e.y * f.x;
        ASSERT_NEAR(patch.area / (0.5 * glm::length(cross)), e.x * f.y - e.y * f.x, 1e-7);
    }
    for (const double area : barycentric_area) ASSERT_EQ(area, 1) << "patches miss or cover twice";
}

TEST(PatchMesh, CoversTheSceneExactly) {
    const Scene scene = varied_scene();
    for (const std::uint32_t wanted : {1u, 1000u, 20000u}) {
        const PatchMesh mesh = PatchMesh::subdivide(scene, {0, wanted});
        EXPECT_NEAR(mesh_area(mesh) / scene_area(scene), 1, 1e-6);
        expect_consistent(scene, mesh);
    }
}

TEST(PatchMesh, FindsThePatchThatHoldsAPoint) {
    const PatchMesh mesh = PatchMesh::subdivide(varied_scene(), {0, 5000});
    std::vector<std::vector<std::uint32_t>> patches_of(mesh.sources.size());
    for (std::uint32_t p = 0; p < mesh.patches.size(); ++p) patches_of[mesh.patches[p].source].push_back(p);
    std::mt19937 random(1);
    std::uniform_real_distribution<float> unit(0, 1);
    for (std::uint32_t s = 0; s < mesh.sources.size(); ++s)
        for (int i = 0; i < 40; ++i) {
            float u = unit(random);
            float v = unit(random);
            if (u + v > 1) u = 1 - u, v = 1 - v;
            const PatchPoint found = mesh.find(s, u, v);
            int holders = 0;
            for (const std::uint32_t p : patches_of[s]) {
                const glm::dvec3 b = within(mesh.patches[p], u, v);
                if (std::min({b.x, b.y, b.z}) < 1e-6) continue; // outside, or too near to an edge to tell
                ++holders;
                ASSERT_EQ(found.patch, p);
                ASSERT_NEAR(found.u, b.y, 1e-4);
                ASSERT_NEAR(found.v, b.z, 1e-4);
            }
            ASSERT_LE(holders, 1) << "two patches overlap";
        }
}

TEST(PatchMesh, FindsCornersAndEdgesOfATriangle) {
    const PatchMesh mesh = PatchMesh::subdivide(varied_scene(), {0, 5000});
    for (std::uint32_t s = 0; s < mesh.sources.size(); ++s)
        for (const glm::vec2 c : {glm::vec2(0, 0), {1, 0}, {0, 1}, {0.5f, 0.5f}, {0.3f, 0}, {0, 0.9f}}) {
            const PatchPoint found = mesh.find(s, c.x, c.y);
            ASSERT_EQ(mesh.patches[found.patch].source, s);
            const glm::dvec3 b = within(mesh.patches[found.patch], c.x, c.y);
            ASSERT_GE(std::min({b.x, b.y, b.z}), -1e-6);
        }
}

TEST(PatchMesh, JoinsWithoutCracks) {
    SceneBuilder builder;
    const std::uint32_t grey = builder.material(lambert(glm::vec3(0.5f)));
    builder.room({-2, 0, -2}, {2, 1.1f, 3}, grey);
    builder.sphere({1, 0.5f, 1}, 0.4f, 1, Normals::flat,
                   grey); // closed too, and its facets share no vertices
    const Scene scene = builder.build();
    for (const std::uint32_t wanted : {1u, 100u, 333u, 5000u}) {
        const PatchMesh mesh = PatchMesh::subdivide(scene, {0, wanted});
        for (const auto& [edge, uses] : edge_uses(mesh)) ASSERT_EQ(uses, 2);
        expect_no_vertex_in_an_edge(mesh);
    }
    expect_no_vertex_in_an_edge(PatchMesh::subdivide(varied_scene(), {0.1f, 0}));
}

TEST(PatchMesh, KeepsToThePatchSize) {
    const Scene scene = varied_scene();
    for (const float size : {0.5f, 0.1f}) {
        const PatchMesh mesh = PatchMesh::subdivide(scene, {size, 0});
        EXPECT_LE(longest_edge(mesh), size);
        // No edge within it is split: triangles of less than a quarter of the size are at least that long.
        EXPECT_LT(mesh.patches.size(), 30 * scene_area(scene) / (size * size));
    }
}

TEST(PatchMesh, HasAsManyPatchesAsAskedForAndHardlyMore) {
    const Scene scene = varied_scene();
    const std::size_t triangles = PatchMesh::subdivide(scene, {0, 1}).patches.size();
    EXPECT_EQ(triangles, 12u + 12 + 80 + 2 + 80 + 80);
    for (const std::uint32_t wanted : {500u, 1000u, 1001u, 30000u}) {
        const PatchMesh mesh = PatchMesh::subdivide(scene, {0, wanted});
        EXPECT_GE(mesh.patches.size(), wanted);
        EXPECT_LE(mesh.patches.size(), wanted + 3); // an edge that four patches share
    }
}

TEST(PatchMesh, SkipsTrianglesWithoutArea) {
    SceneBuilder builder;
    const std::uint32_t grey = builder.material(lambert(glm::vec3(0.5f)));
    builder.quad({0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, grey);
    Scene scene = builder.build();
    Mesh& mesh = scene.meshes[0];
    for (const glm::uvec3 t : {glm::uvec3(0, 0, 1), glm::uvec3(2, 2, 2)}) {
        mesh.triangles.insert(mesh.triangles.begin(), t);
        mesh.triangle_materials.push_back(grey);
    }
    scene.instances.push_back(scene.instances[0]);
    scene.instances.back().to_world = glm::scale(glm::mat4(1), {1, 0, 1}); // flat
    const PatchMesh patches = PatchMesh::subdivide(scene, {0, 64});
    EXPECT_EQ(patches.sources.size(), 2u);
    EXPECT_EQ(patches.sources[0].triangle, 2u);
    EXPECT_EQ(patches.sources[1].triangle, 3u);
    EXPECT_NEAR(mesh_area(patches), 1, 1e-6);

    Scene nothing;
    EXPECT_TRUE(PatchMesh::subdivide(nothing, {0.1f, 100}).patches.empty());
}

TEST(PatchMesh, IsTheSameEveryTime) {
    const Scene scene = varied_scene();
    const PatchMesh a = PatchMesh::subdivide(scene, {0.2f, 3000});
    const PatchMesh b = PatchMesh::subdivide(scene, {0.2f, 3000});
    ASSERT_EQ(a.patches.size(), b.patches.size());
    EXPECT_EQ(a.positions, b.positions);
    for (std::size_t p = 0; p < a.patches.size(); ++p)
        ASSERT_EQ(std::memcmp(&a.patches[p], &b.patches[p], sizeof(Patch)), 0);
    EXPECT_EQ(std::memcmp(a.nodes.data(), b.nodes.data(), a.nodes.size() * sizeof(a.nodes[0])), 0);
}

TEST(PatchMesh, RefinesWhatIsMarkedAndStaysWhole) {
    const Scene scene = varied_scene();
    PatchMesh mesh = PatchMesh::subdivide(scene, {0, 2000});
    std::mt19937 random(2);
    for (int round = 0; round < 6; ++round) {
        const std::vector<Patch> before = mesh.patches;
        std::vector<std::uint8_t> marked(before.size());
        std::size_t marks = 0;
        for (std::uint8_t& m : marked) marks += m = random() % 16 == 0;
        const std::vector<std::uint32_t> origins = mesh.refine(marked);
        ASSERT_EQ(origins.size(), mesh.patches.size());
        EXPECT_GE(mesh.patches.size(), before.size() + marks);
        EXPECT_LE(mesh.patches.size(), before.size() + 8 * marks) << "refinement spreads";
        std::vector<std::uint32_t> parts(before.size());
        std::vector<double> area(before.size());
        for (std::size_t p = 0; p < origins.size(); ++p) {
            ++parts[origins[p]];
            area[origins[p]] += mesh.patches[p].area;
            ASSERT_EQ(mesh.patches[p].source, before[origins[p]].source);
        }
        for (std::size_t p = 0; p < before.size(); ++p) {
            ASSERT_GE(parts[p], marked[p] != 0 ? 2u : 1u);
            ASSERT_EQ(static_cast<float>(area[p]), before[p].area);
        }
        expect_consistent(scene, mesh);
        expect_no_vertex_in_an_edge(mesh);
    }
}

TEST(PatchMesh, RefinesDownToWhereFloatsEnd) {
    SceneBuilder builder;
    const std::uint32_t grey = builder.material(lambert(glm::vec3(0.5f)));
    builder.quad({1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, grey);
    PatchMesh mesh = PatchMesh::subdivide(builder.build(), {0, 2});
    for (int round = 0; round < 120; ++round) { // around one point
        std::vector<std::uint8_t> marked(mesh.patches.size());
        marked[mesh.find(0, 0.3f, 0.2f).patch] = 1;
        mesh.refine(marked);
    }
    expect_no_vertex_in_an_edge(mesh);
    for (const Patch& patch : mesh.patches) EXPECT_GT(patch.area, 0);
    EXPECT_LT(mesh.patches.size(), 2000u);
}

TEST(PatchMesh, RefusesMorePatchesThanItCanNumber) {
    const Scene scene = varied_scene();
    EXPECT_THROW(PatchMesh::subdivide(scene, {1e-5f, 0}), Error);
    EXPECT_THROW(PatchMesh::subdivide(scene, {0, 0xfffffff0u}), Error);
}

} // namespace
} // namespace ajar::test
