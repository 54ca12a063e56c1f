// Morph targets at their default weights, skins at the pose of the nodes.
#include "unit/import/gltf_builder.hpp"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

namespace ajar::test {
namespace {

using Positions = std::vector<glm::vec3>;

GltfBuilder morphing(const nlohmann::json& mesh_weights) {
    GltfBuilder b = triangle();
    auto& primitive = b.json["meshes"][0]["primitives"][0];
    const unsigned first = b.add(Positions{{0, 0, 1}, {0, 0, 1}, {0, 0, 1}});
    const unsigned second = b.add(Positions{{4, 0, 0}, {0, 0, 0}, {0, 0, 0}});
    primitive["targets"] = {{{"POSITION", first}}, {{"POSITION", second}}};
    if (!mesh_weights.is_null()) b.json["meshes"][0]["weights"] = mesh_weights;
    return b;
}

TEST(GltfMorph, AddsTheWeightedTargets) {
    EXPECT_EQ(import(morphing({0.5, 0.25})).scene.meshes.at(0).positions,
              (Positions{{1, 0, 0.5f}, {1, 0, 0.5f}, {0, 1, 0.5f}}));
    EXPECT_EQ(import(morphing(nullptr)).scene.meshes.at(0).positions[0], glm::vec3(0));
}

TEST(GltfMorph, TakesTheNodesWeightsBeforeTheMeshes) {
    GltfBuilder b = morphing({1, 0});
    b.push("nodes", {{"mesh", 0}, {"weights", {0, 1}}});
    b.json["scenes"][0]["nodes"] = {0, 1, 0};
    const Scene scene = import(b).scene;
    ASSERT_EQ(scene.meshes.size(), 2u);
    EXPECT_EQ(scene.meshes[scene.instances.at(0).mesh].positions[0], glm::vec3(0, 0, 1));
    EXPECT_EQ(scene.meshes[scene.instances.at(1).mesh].positions[0], glm::vec3(4, 0, 0));
}

TEST(GltfMorph, MakesFlatNormalsOfTheMorphedShape) {
    GltfBuilder b = triangle();
    const unsigned target =
        b.add(Positions{{0, 0, 0}, {0, 0, 0}, {0, -1, 1}}); // turns the triangle to face -y
    b.json["meshes"][0]["primitives"][0]["targets"] = {{{"POSITION", target}}};
    b.json["meshes"][0]["weights"] = {1};
    EXPECT_EQ(import(b).scene.meshes.at(0).normals[0], glm::vec3(0, -1, 0));
}

TEST(GltfMorph, RejectsTargetsOfAnotherLengthAndInfinitePositions) {
    GltfBuilder b = morphing({1, 1});
    b.json["meshes"][0]["primitives"][0]["targets"][1]["POSITION"] = b.add(Positions(2));
    EXPECT_NE(import_error(b).find("targets[1].POSITION"), std::string::npos);
    EXPECT_NE(import_error(morphing({3e38, 3e38})).find("not finite"), std::string::npos);
}

// The triangle follows two joints: node 1 (moved by +x 10) and its child node 2 (turned a quarter about z).
GltfBuilder skinned(const std::vector<glm::vec4>& weights) {
    GltfBuilder b = triangle();
    auto& attributes = b.json["meshes"][0]["primitives"][0]["attributes"];
    const unsigned joints = b.view(std::vector<std::uint8_t>{0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0});
    attributes["JOINTS_0"] = b.accessor(joints, U8, 3, "VEC4");
    attributes["WEIGHTS_0"] = b.add(weights);
    const float h = std::sqrt(0.5f);
    b.json["nodes"] = {{{"mesh", 0}, {"skin", 0}, {"translation", {100, 100, 100}}},
                       {{"children", {2}}, {"translation", {10, 0, 0}}},
                       {{"rotation", {0, 0, h, h}}}};
    b.json["scenes"][0]["nodes"] = {0, 1};
    b.json["skins"] = {{{"joints", {1, 2}}}};
    return b;
}

void expect_near(const glm::vec3& a, const glm::vec3& b) { EXPECT_NEAR(glm::length(a - b), 0, 1e-5f); }

TEST(GltfSkin, FollowsItsJointsAndNotItsNode) {
    const Scene scene = import(skinned(std::vector<glm::vec4>(3, {1, 0, 0, 0}))).scene;
    EXPECT_EQ(scene.instances.at(0).to_world, glm::mat4(1));
    expect_near(scene.meshes.at(0).positions[1], {11, 0, 0});
}

TEST(GltfSkin, BlendsByWeightWhateverTheirSum) {
    const Mesh mesh = import(skinned({{0, 2, 0, 0}, {0, 1, 0, 0}, {1, 1, 0, 0}})).scene.meshes.at(0);
    expect_near(mesh.positions[0], {10, 0, 0});
    expect_near(mesh.positions[1], {10, 1, 0});      // (1, 0, 0) turned to (0, 1, 0), moved by 10
    expect_near(mesh.positions[2], {9.5f, 0.5f, 0}); // between (10, 1, 0) and (9, 0, 0)
}

TEST(GltfSkin, AppliesInverseBindMatrices) {
    GltfBuilder b = skinned(std::vector<glm::vec4>(3, {1, 0, 0, 0}));
    const glm::mat4 bind = glm::translate(glm::mat4(1), glm::vec3(-10, 5, 0));
    b.json["skins"][0]["inverseBindMatrices"] = b.add(std::vector<glm::mat4>{bind, glm::mat4(1)});
    expect_near(import(b).scene.meshes.at(0).positions[1], {1, 5, 0});
}

TEST(GltfSkin, TurnsNormalsWithTheInverseTranspose) {
    GltfBuilder b = skinned(std::vector<glm::vec4>(3, {1, 0, 0, 0}));
    b.json["nodes"][1]["scale"] = {2, 1, -1};
    b.json["meshes"][0]["primitives"][0]["attributes"]["NORMAL"] = b.add(Positions(3, {1, 0, 1}));
    // Scaled by (2, 1, -1), a normal goes as (1/2, 1, -1): (1, 0, 1) -> (1/2, 0, -1).
    expect_near(import(b).scene.meshes.at(0).normals[0], glm::normalize(glm::vec3(0.5f, 0, -1)));
}

TEST(GltfSkin, RejectsJointsThatTheSkinLacks) {
    GltfBuilder b = skinned(std::vector<glm::vec4>(3, {1, 1, 0, 0}));
    b.json["skins"][0]["joints"] = {1};
    EXPECT_NE(import_error(b).find("joint 1"), std::string::npos);
    b.json["skins"][0]["joints"] = {77};
    EXPECT_NE(import_error(b).find("skins[0].joints"), std::string::npos);
    b.json["skins"][0].erase("joints");
    EXPECT_NE(import_error(b).find("skins[0].joints"), std::string::npos);
}

TEST(GltfSkin, RejectsTooFewMatricesAndMissingWeights) {
    GltfBuilder b = skinned(std::vector<glm::vec4>(3, {1, 0, 0, 0}));
    b.json["skins"][0]["inverseBindMatrices"] = b.add(std::vector<glm::mat4>{glm::mat4(1)});
    EXPECT_NE(import_error(b).find("inverseBindMatrices"), std::string::npos);
    b = skinned(std::vector<glm::vec4>(3, {1, 0, 0, 0}));
    b.json["meshes"][0]["primitives"][0]["attributes"].erase("WEIGHTS_0");
    EXPECT_NE(import_error(b).find("WEIGHTS_0"), std::string::npos);
}

} // namespace
} // namespace ajar::test
