// Primitives and meshes: modes, indices, missing attributes, merging.
#include "unit/import/gltf_builder.hpp"

#include <gtest/gtest.h>

namespace ajar::test {
namespace {

const std::vector<glm::vec3> FIVE{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 2, 0}};

std::vector<glm::uvec3> triangles_of(int mode, const std::vector<std::uint16_t>& indices) {
    GltfBuilder b;
    const unsigned position = b.add(FIVE);
    const unsigned normal = b.add(std::vector<glm::vec3>(5, {0, 0, 1}));
    b.show({{"attributes", {{"POSITION", position}, {"NORMAL", normal}}},
            {"indices", b.add(indices)},
            {"mode", mode}});
    const Scene scene = import(b).scene;
    return scene.meshes.empty() ? std::vector<glm::uvec3>{} : scene.meshes[0].triangles;
}

using Triangles = std::vector<glm::uvec3>;

TEST(GltfPrimitive, ReadsTriangles) {
    EXPECT_EQ(triangles_of(4, {0, 1, 2, 1, 3, 2}), (Triangles{{0, 1, 2}, {1, 3, 2}}));
}

TEST(GltfPrimitive, AlternatesTheWindingOfStrips) { // glTF 2.0, section 3.7.2.1
    EXPECT_EQ(triangles_of(5, {0, 1, 2, 3, 4}), (Triangles{{0, 1, 2}, {1, 3, 2}, {2, 3, 4}}));
}

TEST(GltfPrimitive, DropsTheDegenerateTrianglesOfStripsAndKeepsTheWinding) {
    EXPECT_EQ(triangles_of(5, {0, 1, 2, 2, 3, 3, 4, 2}), (Triangles{{0, 1, 2}, {3, 2, 4}}));
}

TEST(GltfPrimitive, ReadsFans) {
    EXPECT_EQ(triangles_of(6, {0, 1, 3, 2}), (Triangles{{1, 3, 0}, {3, 2, 0}}));
}

TEST(GltfPrimitive, IgnoresIndicesBeyondTheLastWholeTriangle) {
    EXPECT_EQ(triangles_of(4, {0, 1, 2, 3, 4}), (Triangles{{0, 1, 2}}));
}

TEST(GltfPrimitive, SkipsPointsAndLinesWithOneWarning) {
    GltfBuilder b = triangle();
    for (const int mode : {0, 1, 2, 3})
        b.json["meshes"][0]["primitives"].push_back({{"attributes", {{"POSITION", 0}}}, {"mode", mode}});
    const ImportResult result = import(b);
    EXPECT_EQ(result.scene.meshes.at(0).triangles.size(), 1u);
    EXPECT_EQ(result.info.skipped_primitives, 4u);
    ASSERT_EQ(result.info.warnings.size(), 1u);
    EXPECT_NE(result.info.warnings[0].find("4 primitives"), std::string::npos);
}

TEST(GltfPrimitive, ReadsIndicesOfEveryType) {
    for (const Component component : {U8, U16, U32}) {
        GltfBuilder b = triangle();
        const unsigned view = component == U8    ? b.view(std::vector<std::uint8_t>{2, 0, 1})
                              : component == U16 ? b.view(std::vector<std::uint16_t>{2, 0, 1})
                                                 : b.view(std::vector<std::uint32_t>{2, 0, 1});
        b.json["meshes"][0]["primitives"][0]["indices"] = b.accessor(view, component, 3, "SCALAR");
        EXPECT_EQ(import(b).scene.meshes.at(0).positions[0], glm::vec3(0, 1, 0));
    }
}

TEST(GltfPrimitive, RejectsAVertexIndexOutOfRange) {
    GltfBuilder b = triangle();
    b.json["meshes"][0]["primitives"][0]["indices"] = b.add(std::vector<std::uint16_t>{0, 1, 3});
    EXPECT_NE(import_error(b).find("vertex index 3 is out of range"), std::string::npos);
    b.json["accessors"][1]["componentType"] = F32;
    EXPECT_NE(import_error(b), "");
}

TEST(GltfPrimitive, RejectsAPrimitiveWithoutPositions) {
    GltfBuilder b = triangle();
    b.json["meshes"][0]["primitives"][0]["attributes"] = nlohmann::json::object();
    EXPECT_NE(import_error(b).find("POSITION"), std::string::npos);
    b.json["meshes"][0]["primitives"][0].erase("attributes");
    EXPECT_NE(import_error(b).find("attributes"), std::string::npos);
}

TEST(GltfPrimitive, RejectsPositionsThatAreNotFinite) {
    for (const float value : {INFINITY, -INFINITY, NAN}) {
        GltfBuilder b;
        const unsigned position = b.add(std::vector<glm::vec3>{{0, 0, 0}, {1, value, 0}, {0, 1, 0}});
        b.show({{"attributes", {{"POSITION", position}}}});
        EXPECT_NE(import_error(b).find("not finite"), std::string::npos);
    }
}

TEST(GltfPrimitive, RejectsAttributesOfAnotherLength) {
    GltfBuilder b = triangle();
    b.json["meshes"][0]["primitives"][0]["attributes"]["NORMAL"] = b.add(std::vector<glm::vec3>(2));
    EXPECT_NE(import_error(b).find("NORMAL has 2 elements for 3 positions"), std::string::npos);
}

TEST(GltfPrimitive, MakesFlatNormalsAndUnweldsWhereNoneAreGiven) {
    GltfBuilder b; // two faces of a roof that share the edge 0-1
    const unsigned position = b.add(std::vector<glm::vec3>{{0, 0, 0}, {0, 0, 1}, {1, -1, 0}, {-1, -1, 0}});
    b.show({{"attributes", {{"POSITION", position}}},
            {"indices", b.add(std::vector<std::uint16_t>{0, 1, 2, 1, 0, 3})}});
    const Mesh mesh = import(b).scene.meshes.at(0);
    ASSERT_EQ(mesh.positions.size(), 6u);
    const float h = std::sqrt(0.5f);
    for (unsigned k = 0; k < 3; ++k) {
        EXPECT_NEAR(glm::length(mesh.normals[mesh.triangles[0][k]] - glm::vec3(h, h, 0)), 0, 1e-6f);
        EXPECT_NEAR(glm::length(mesh.normals[mesh.triangles[1][k]] - glm::vec3(-h, h, 0)), 0, 1e-6f);
    }
}

TEST(GltfPrimitive, NormalisesNormalsAndReplacesUnusableOnes) {
    GltfBuilder b = triangle();
    b.json["meshes"][0]["primitives"][0]["attributes"]["NORMAL"] =
        b.add(std::vector<glm::vec3>{{0, 0, 5}, {0, 0, 0}, {NAN, 0, 0}});
    EXPECT_EQ(import(b).scene.meshes.at(0).normals, std::vector<glm::vec3>(3, {0, 0, 1}));
}

TEST(GltfPrimitive, ReplacesTextureCoordinatesThatAreNotFinite) {
    GltfBuilder b = triangle();
    b.json["meshes"][0]["primitives"][0]["attributes"]["TEXCOORD_0"] =
        b.add(std::vector<glm::vec2>{{0, 0}, {NAN, 0.5f}, {0, 1}});
    const ImportResult result = import(b);
    EXPECT_EQ(result.scene.meshes.at(0).uv0[1], glm::vec2(0, 0.5f));
    EXPECT_EQ(result.info.warnings.size(), 1u);
}

TEST(GltfPrimitive, KeepsOnlyTheVerticesThatAPrimitiveUses) {
    GltfBuilder b;
    std::vector<glm::vec3> many(1000);
    for (std::size_t i = 0; i < many.size(); ++i)
        many[i] = {static_cast<float>(i), static_cast<float>(i % 2), 0};
    const unsigned position = b.add(many);
    const unsigned normal = b.add(std::vector<glm::vec3>(1000, {0, 0, 1}));
    b.show({{"attributes", {{"POSITION", position}, {"NORMAL", normal}}},
            {"indices", b.add(std::vector<std::uint16_t>{900, 3, 50})}});
    const Mesh mesh = import(b).scene.meshes.at(0);
    ASSERT_EQ(mesh.positions.size(), 3u);
    EXPECT_EQ(mesh.positions[mesh.triangles[0].x], many[900]);
    EXPECT_EQ(mesh.positions[mesh.triangles[0].y], many[3]);
    EXPECT_EQ(mesh.positions[mesh.triangles[0].z], many[50]);
}

TEST(GltfMesh, MergesPrimitivesAndFillsMissingAttributes) {
    GltfBuilder b = textured_triangle({{"name", "red"}});
    b.json["meshes"][0]["primitives"].push_back({{"attributes", {{"POSITION", 0}, {"NORMAL", 1}}}});
    const Scene scene = import(b).scene;
    const Mesh& mesh = scene.meshes.at(0);
    ASSERT_EQ(mesh.positions.size(), 6u);
    EXPECT_EQ(mesh.triangles, (Triangles{{0, 1, 2}, {3, 4, 5}}));
    EXPECT_EQ(mesh.uv0[1], glm::vec2(1, 0));
    EXPECT_EQ(mesh.uv0[4], glm::vec2(0, 0));
    EXPECT_EQ(mesh.triangle_materials, (std::vector<std::uint32_t>{0, 1}));
    EXPECT_EQ(scene.materials.at(1).name, "default");
    EXPECT_EQ(scene.materials.at(1).metallic, 1.0f);
}

TEST(GltfMesh, IsSharedByTheNodesThatShowIt) {
    GltfBuilder b = triangle();
    b.push("nodes", {{"mesh", 0}, {"scale", {-1, 2, 3}}, {"name", "mirrored"}});
    b.json["scenes"][0]["nodes"].push_back(1);
    const Scene scene = import(b).scene;
    ASSERT_EQ(scene.instances.size(), 2u);
    EXPECT_EQ(scene.meshes.size(), 1u);
    EXPECT_EQ(scene.instances[1].name, "mirrored");
    EXPECT_EQ(scene.instances[1].mesh, scene.instances[0].mesh);
    EXPECT_LT(glm::determinant(glm::mat3(scene.instances[1].to_world)), 0);
}

TEST(GltfMesh, IsOmittedWhenTheSceneDoesNotShowIt) {
    GltfBuilder b = triangle();
    b.push("meshes", {{"primitives", {{{"attributes", {{"POSITION", 99}}}}}}}); // broken, and nobody looks
    EXPECT_EQ(import(b).scene.meshes.size(), 1u);
}

} // namespace
} // namespace ajar::test
