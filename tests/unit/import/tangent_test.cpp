// Tangents against closed forms and against the properties that define MikkTSpace.
#include "import/tangents.hpp"

#include "import/tangent_groups.hpp"
#include "unit/import/gltf_builder.hpp"

#include <gtest/gtest.h>
#include <random>

namespace ajar::gltf {
namespace {

// A grid in the plane z = 0 with u, v as functions of x, y; n x n squares of two triangles.
template <class Uv> Primitive grid(unsigned n, Uv uv) {
    Primitive p;
    for (unsigned y = 0; y <= n; ++y)
        for (unsigned x = 0; x <= n; ++x) {
            const float fx = static_cast<float>(x), fy = static_cast<float>(y);
            p.positions.emplace_back(fx, fy, 0);
            p.normals.emplace_back(0, 0, 1);
            p.uv[0].push_back(uv(fx, fy));
        }
    for (unsigned y = 0; y < n; ++y)
        for (unsigned x = 0; x < n; ++x) {
            const unsigned a = y * (n + 1) + x;
            p.triangles.emplace_back(a, a + 1, a + n + 2);
            p.triangles.emplace_back(a, a + n + 2, a + n + 1);
        }
    return p;
}

glm::vec4 tangent_of(const Primitive& p, std::size_t triangle, int corner) {
    return p.tangents[p.triangles[triangle][corner]];
}

void expect_all(const Primitive& p, const glm::vec4& expected) {
    for (std::size_t t = 0; t < p.triangles.size(); ++t)
        for (int k = 0; k < 3; ++k)
            EXPECT_NEAR(glm::length(tangent_of(p, t, k) - expected), 0, 1e-5f) << "triangle " << t;
}

// v grows downwards in glTF: where the picture is upright (v falls as y grows) the bitangent w * cross(n, t)
// is +y.
TEST(Tangents, FollowUAndPointTheBitangentUpThePicture) {
    Primitive upright = grid(2, [](float x, float y) { return glm::vec2(x, -y); });
    make_tangents({}, upright);
    expect_all(upright, {1, 0, 0, 1});
    Primitive mirrored = grid(2, [](float x, float y) { return glm::vec2(-x, -y); });
    make_tangents({}, mirrored);
    expect_all(mirrored, {-1, 0, 0, -1});
    Primitive turned = grid(2, [](float x, float y) { return glm::vec2(y, x); });
    make_tangents({}, turned);
    expect_all(turned, {0, 1, 0, 1});
}

TEST(Tangents, UseTheTransformedCoordinatesOfTheNormalMap) {
    TextureUse use;
    use.uv_row_u = {0, 3, 0.5f};
    use.uv_row_v = {2, 0, 0};
    Primitive p = grid(2, [](float x, float y) { return glm::vec2(x, y); });
    make_tangents(use, p);
    expect_all(p, {0, 1, 0, 1});
}

TEST(Tangents, KeepTheVerticesOfASmoothPatch) {
    Primitive p = grid(8, [](float x, float y) { return glm::vec2(x, -y); });
    make_tangents({}, p);
    EXPECT_EQ(p.positions.size(), 81u);
    EXPECT_EQ(p.tangents.size(), 81u);
}

TEST(Tangents, SplitTheVerticesOfAMirrorSeam) {
    Primitive p = grid(2, [](float x, float y) { return glm::vec2(std::abs(x - 1), -y); });
    p.colors.assign(p.positions.size(), glm::vec4(1));
    make_tangents({}, p);
    EXPECT_EQ(p.positions.size(), 9u + 3u);
    EXPECT_EQ(p.colors.size(), p.positions.size());
    for (std::size_t t = 0; t < p.triangles.size(); ++t)
        for (int k = 0; k < 3; ++k) {
            const bool left = p.positions[p.triangles[t][0]].x + p.positions[p.triangles[t][1]].x +
                                  p.positions[p.triangles[t][2]].x <
                              3;
            const float sign = left ? -1.0f : 1.0f;
            EXPECT_EQ(tangent_of(p, t, k), glm::vec4(sign, 0, 0, sign));
        }
}

// Two triangles at one vertex whose directions differ, one with twice the angle of the other.
TEST(Tangents, AreWeightedByTheAngleAtTheCorner) {
    Primitive p;
    const glm::vec3 n(0, 0, 1);
    p.positions = {{0, 0, 0}, {1, 0, 0}, {0.5f, std::sqrt(0.75f), 0}, {-1, 0, 0}}; // 60 degrees, then 120
    p.normals.assign(4, n);
    p.triangles = {{0, 1, 2}, {0, 2, 3}};
    p.uv[0] = {{0, 0}, {1, 0}, {0.5f, -std::sqrt(0.75f)}, {-1, 0.3f}};
    make_tangents({}, p);
    const auto derivative = [&](const glm::uvec3& t) { // of the position by u, unit
        const glm::vec3 d1 = p.positions[t.y] - p.positions[t.x], d2 = p.positions[t.z] - p.positions[t.x];
        const glm::vec2 s1 = p.uv[0][t.y] - p.uv[0][t.x], s2 = p.uv[0][t.z] - p.uv[0][t.x];
        return glm::normalize((s2.y * d1 - s1.y * d2) / (s1.x * s2.y - s2.x * s1.y));
    };
    const glm::vec3 first = derivative({0, 1, 2}), second = derivative({0, 2, 3});
    ASSERT_LT(glm::dot(first, second), 0.99f);
    const glm::vec3 expected = glm::normalize(first * 1.0f + second * 2.0f);
    EXPECT_NEAR(glm::length(glm::vec3(tangent_of(p, 0, 0)) - expected), 0, 1e-5f);
}

TEST(Tangents, OfATriangleWithoutTextureAreaComeFromItsNeighbour) {
    Primitive p = grid(1, [](float x, float y) { return glm::vec2(x, -y); });
    p.positions.push_back({2, 0.5f, 0});
    p.normals.push_back({0, 0, 1});
    p.uv[0].push_back({1, -0.5f}); // on the line between the two corners it joins
    p.triangles.push_back({1, 4, 3});
    make_tangents({}, p);
    EXPECT_EQ(tangent_of(p, 2, 0), tangent_of(p, 0, 1));
}

TEST(Tangents, AreAlwaysUnitAndAcrossTheNormal) {
    std::mt19937 random(1);
    const auto coarse = [&](unsigned n) { return static_cast<float>(random() % n); };
    for (int round = 0; round < 50;
         ++round) { // coarse numbers make degenerate, mirrored and repeated triangles
        Primitive p;
        for (int i = 0; i < 40; ++i) {
            p.positions.emplace_back(coarse(3), coarse(3), coarse(3));
            p.normals.push_back(glm::normalize(glm::vec3(coarse(3) - 1, coarse(3) - 1, coarse(2) + 0.5f)));
            p.uv[0].emplace_back(coarse(3), coarse(3));
        }
        for (int i = 0; i < 100; ++i) p.triangles.emplace_back(random() % 40, random() % 40, random() % 40);
        const Primitive before = p;
        make_tangents({}, p);
        ASSERT_EQ(p.tangents.size(), p.positions.size());
        for (std::size_t i = 0; i < p.tangents.size(); ++i) {
            EXPECT_NEAR(glm::length(glm::vec3(p.tangents[i])), 1, 1e-3f);
            EXPECT_NEAR(glm::dot(glm::vec3(p.tangents[i]), p.normals[i]), 0, 1e-3f);
            EXPECT_EQ(std::abs(p.tangents[i].w), 1.0f);
        }
        for (std::size_t t = 0; t < p.triangles.size(); ++t)
            for (int k = 0; k < 3; ++k)
                EXPECT_EQ(p.positions[p.triangles[t][k]], before.positions[before.triangles[t][k]]);
    }
}

// A million triangles around one vertex: quadratic work would take hours.
TEST(Tangents, OfAHugeFanTakeLinearTime) {
    Primitive p;
    constexpr unsigned n = 200'000;
    p.positions.push_back({0, 0, 0});
    p.uv[0].push_back({0, 0});
    for (unsigned i = 0; i <= n; ++i) {
        const float angle = static_cast<float>(i) * 6.2831853f / n;
        p.positions.emplace_back(std::cos(angle), std::sin(angle), 0);
        p.uv[0].emplace_back(std::cos(angle), -std::sin(angle));
        if (i > 0) p.triangles.emplace_back(0, i, i + 1);
    }
    p.normals.assign(p.positions.size(), {0, 0, 1});
    make_tangents({}, p);
    EXPECT_NEAR(tangent_of(p, 0, 0).x, 1, 1e-3f);
}

TEST(Tangents, WeldEqualVerticesOnly) {
    const std::vector<glm::vec3> positions{{0, 0, 0}, {1, 0, 0}, {-0.0f, 0, 0}, {0, 0, 0}};
    const std::vector<glm::vec3> normals(4, {0, 0, 1});
    const std::vector<glm::vec2> uv{{0, 0}, {0, 0}, {0, 0}, {0, 1}};
    EXPECT_EQ(weld(positions, normals, uv), (std::vector<std::uint32_t>{0, 1, 0, 3}));
}

TEST(Tangents, AreMadeForNormalMapsOnly) {
    using namespace test;
    GltfBuilder b = textured_triangle({{"normalTexture", {{"index", 0}}}});
    b.push("images", {{"bufferView", b.view(one_texel(128, 128, 255))}});
    b.push("textures", {{"source", 0}});
    const Mesh with = import(b).scene.meshes.at(0);
    ASSERT_EQ(with.tangents.size(), 3u);
    EXPECT_EQ(with.tangents[0], glm::vec4(1, 0, 0, -1)); // v grows with y: the picture is upside down
    b.json["materials"][0] = nlohmann::json::object();
    EXPECT_TRUE(import(b).scene.meshes.at(0).tangents.empty());
}

TEST(Tangents, OfTheFileAreKeptAndNormalised) {
    using namespace test;
    GltfBuilder b = textured_triangle({{"normalTexture", {{"index", 0}}}});
    b.push("images", {{"bufferView", b.view(one_texel(128, 128, 255))}});
    b.push("textures", {{"source", 0}});
    b.json["meshes"][0]["primitives"][0]["attributes"]["TANGENT"] =
        b.add(std::vector<glm::vec4>{{0, 2, 0, 1}, {0, 1, 0, -1}, {0, 0, 0, 0}});
    const Mesh mesh = import(b).scene.meshes.at(0);
    EXPECT_EQ(mesh.tangents[0], glm::vec4(0, 1, 0, 1));
    EXPECT_EQ(mesh.tangents[1], glm::vec4(0, 1, 0, -1));
    EXPECT_NEAR(glm::length(glm::vec3(mesh.tangents[2])), 1, 1e-6f);
}

} // namespace
} // namespace ajar::gltf
