// The node tree, scenes, cameras and lights.
#include "unit/import/gltf_builder.hpp"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>
#include <numbers>

namespace ajar::test {
namespace {

void expect_near(const glm::mat4& a, const glm::mat4& b) {
    for (int c = 0; c < 4; ++c)
        for (int r = 0; r < 4; ++r) EXPECT_NEAR(a[c][r], b[c][r], 1e-5f) << "column " << c << ", row " << r;
}

TEST(GltfNodes, MultipliesTransformsDownTheTree) {
    GltfBuilder b = triangle();
    const float h = std::sqrt(0.5f); // a quarter turn about Z
    b.json["nodes"] = {{{"children", {1}}, {"translation", {1, 2, 3}}},
                       {{"children", {2}}, {"rotation", {0, 0, h, h}}},
                       {{"mesh", 0}, {"scale", {2, -3, 4}}}};
    const Scene scene = import(b).scene;
    const glm::mat4 expected = glm::translate(glm::mat4(1), glm::vec3(1, 2, 3)) *
                               glm::rotate(glm::mat4(1), glm::radians(90.0f), glm::vec3(0, 0, 1)) *
                               glm::scale(glm::mat4(1), glm::vec3(2, -3, 4));
    expect_near(scene.instances.at(0).to_world, expected);
    EXPECT_EQ(scene.instances[0].name, "node 2");
}

TEST(GltfNodes, ReadsMatricesByColumns) {
    GltfBuilder b = triangle();
    b.json["nodes"][0]["matrix"] = {1, 0, 0, 0, 0, 2, 0, 0, 0, 0, 3, 0, 4, 5, 6, 1};
    EXPECT_EQ(import(b).scene.instances.at(0).to_world[3], glm::vec4(4, 5, 6, 1));
    b.json["nodes"][0]["matrix"] = {1, 2, 3};
    EXPECT_NE(import_error(b).find("nodes[0].matrix"), std::string::npos);
    b.json["nodes"][0]["matrix"] = {1, 0, 0, 0.5, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    EXPECT_NE(import_error(b).find("nodes[0].matrix"), std::string::npos);
}

TEST(GltfNodes, TakesAZeroRotationAsNone) {
    GltfBuilder b = triangle();
    b.json["nodes"][0]["rotation"] = {0, 0, 0, 0};
    expect_near(import(b).scene.instances.at(0).to_world, glm::mat4(1));
}

TEST(GltfNodes, RejectsCyclesAndSecondParents) {
    GltfBuilder b = triangle();
    b.json["nodes"] = {{{"children", {1}}}, {{"children", {0}}}};
    EXPECT_NE(import_error(b).find("cycle"), std::string::npos);
    b.json["nodes"] = {{{"children", {0}}}};
    EXPECT_NE(import_error(b).find("cycle"), std::string::npos);
    b.json["nodes"] = {{{"children", {2}}}, {{"children", {2}}}, {{"mesh", 0}}};
    EXPECT_NE(import_error(b).find("also a child"), std::string::npos);
    b.json["nodes"] = {{{"children", {7}}}};
    EXPECT_NE(import_error(b).find("node 7 does not exist"), std::string::npos);
}

TEST(GltfNodes, ReadsATreeOfAnyDepth) {
    GltfBuilder b = triangle();
    b.json["nodes"] = nlohmann::json::array();
    constexpr int depth = 100'000;
    for (int i = 0; i < depth; ++i) b.push("nodes", {{"children", {i + 1}}, {"translation", {0.5, 0, 0}}});
    b.push("nodes", {{"mesh", 0}});
    EXPECT_EQ(import(b).scene.instances.at(0).to_world[3].x, 0.5f * depth);
}

TEST(GltfNodes, RejectsTransformsThatOverflow) {
    GltfBuilder b = triangle();
    b.json["nodes"] = {{{"children", {1}}, {"scale", {1e30, 1, 1}}}, {{"mesh", 0}, {"scale", {1e30, 1, 1}}}};
    EXPECT_NE(import_error(b).find("not finite"), std::string::npos);
}

TEST(GltfNodes, AreNotShownWithAScaleOfZero) {
    GltfBuilder b = triangle();
    b.json["nodes"][0]["scale"] = {1, 0, 1};
    const ImportResult result = import(b);
    EXPECT_TRUE(result.scene.instances.empty());
    EXPECT_NE(result.info.warnings.at(0).find("its scale is zero"), std::string::npos);
}

TEST(GltfNodes, RejectsAWorldTooLargeToMeasure) {
    GltfBuilder b = triangle();
    b.json["nodes"][0]["translation"] = {1e19, 0, 0};
    EXPECT_NE(import_error(b).find("too far"), std::string::npos) << import_error(b);
}

GltfBuilder two_scenes() {
    GltfBuilder b = triangle();
    b.json["nodes"] = {{{"mesh", 0}, {"name", "a"}}, {{"mesh", 0}, {"name", "b"}}};
    b.json["scenes"] = {{{"nodes", {0}}, {"name", "first"}}, {{"nodes", {1}}, {"name", "second"}}};
    b.json["scene"] = 1;
    return b;
}

TEST(GltfScenes, AreChosenByDefaultNameOrIndex) {
    const GltfBuilder b = two_scenes();
    const auto shown = [&](const char* scene) {
        ImportOptions options;
        options.scene = scene;
        return import(b, options).scene.instances.at(0).name;
    };
    EXPECT_EQ(shown(""), "b");
    EXPECT_EQ(shown("first"), "a");
    EXPECT_EQ(shown("0"), "a");
    EXPECT_EQ(import(b).scene.name, "second");
    ImportOptions options;
    for (const char* scene : {"third", "2", "-1", "0x"}) {
        options.scene = scene;
        EXPECT_NE(import_error(b, options).find("there is no scene"), std::string::npos) << scene;
    }
}

TEST(GltfScenes, AreEveryRootWhereTheFileHasNone) {
    GltfBuilder b = two_scenes();
    b.json.erase("scenes");
    b.json.erase("scene");
    EXPECT_EQ(import(b).scene.instances.size(), 2u);
}

TEST(GltfScenes, MayListANodeAndItsChild) {
    GltfBuilder b = two_scenes();
    b.json["nodes"][0]["children"] = {1};
    b.json["scenes"][1]["nodes"] = {0, 1, 0};
    EXPECT_EQ(import(b).scene.instances.size(), 2u);
}

TEST(GltfCameras, AreReadWithoutTheirScale) {
    GltfBuilder b = triangle();
    b.json["cameras"] = {
        {{"type", "perspective"}, {"perspective", {{"yfov", 0.5}, {"znear", 0.1}}}, {"name", "main"}},
        {{"type", "orthographic"}, {"orthographic", {{"xmag", 2}, {"ymag", 3}, {"znear", 0}, {"zfar", 1}}}}};
    b.push("nodes", {{"camera", 0}, {"translation", {0, 0, 5}}, {"scale", {2, 3, 4}}});
    b.push("nodes", {{"camera", 1}, {"name", "side"}});
    b.json["scenes"][0]["nodes"] = {0, 1, 2};
    const ImportResult result = import(b);
    ASSERT_EQ(result.scene.cameras.size(), 2u);
    const Camera& main = result.scene.cameras[0];
    EXPECT_EQ(main.name, "main");
    EXPECT_EQ(main.yfov, 0.5f);
    expect_near(main.to_world, glm::translate(glm::mat4(1), glm::vec3(0, 0, 5)));
    EXPECT_EQ(result.scene.cameras[1].kind, CameraKind::orthographic);
    EXPECT_EQ(result.scene.cameras[1].ymag, 3.0f);
    EXPECT_EQ(result.scene.cameras[1].name, "side");
    EXPECT_FALSE(result.info.automatic_camera);
}

TEST(GltfCameras, AreMadeWhereTheSceneHasNone) {
    const ImportResult result = import(triangle());
    EXPECT_TRUE(result.info.automatic_camera);
    EXPECT_EQ(result.scene.cameras.size(), 1u);
}

TEST(GltfCameras, RejectImpossibleLenses) {
    for (const char* lens :
         {R"({"type": "perspective", "perspective": {"yfov": 0}})",
          R"({"type": "perspective", "perspective": {"yfov": 3.2}})", R"({"type": "perspective"})",
          R"({"type": "orthographic", "orthographic": {"ymag": 0}})", R"({"type": "fisheye"})"}) {
        GltfBuilder b = triangle();
        b.json["cameras"] = nlohmann::json::array({nlohmann::json::parse(lens)});
        b.json["nodes"][0]["camera"] = 0;
        EXPECT_NE(import_error(b).find("cameras[0]"), std::string::npos) << lens;
    }
}

GltfBuilder with_light(const char* light) {
    GltfBuilder b = triangle();
    b.json["extensionsUsed"] = {"KHR_lights_punctual"};
    b.json["extensions"]["KHR_lights_punctual"]["lights"] =
        nlohmann::json::array({nlohmann::json::parse(light)});
    b.json["nodes"][0]["extensions"]["KHR_lights_punctual"]["light"] = 0;
    return b;
}

TEST(GltfLights, ArePlacedInTheWorld) {
    GltfBuilder b = with_light(R"({"type": "spot", "color": [1, 0.5, 0], "intensity": 10, "range": 7,
                                   "spot": {"innerConeAngle": 0.1, "outerConeAngle": 0.2}})");
    const float h = std::sqrt(0.5f); // a quarter turn about X takes -Z to +Y
    b.json["nodes"][0]["rotation"] = {h, 0, 0, h};
    b.json["nodes"][0]["translation"] = {1, 2, 3};
    const Light light = import(b).scene.lights.at(0);
    EXPECT_EQ(light.kind, LightKind::spot);
    EXPECT_EQ(light.intensity, glm::vec3(10, 5, 0));
    EXPECT_EQ(light.position, glm::vec3(1, 2, 3));
    EXPECT_NEAR(glm::length(light.direction - glm::vec3(0, 1, 0)), 0, 1e-6f);
    EXPECT_EQ(light.range, 7.0f);
    EXPECT_EQ(light.inner_cone_angle, 0.1f);
    EXPECT_EQ(light.outer_cone_angle, 0.2f);
}

TEST(GltfLights, HaveTheDefaultsOfTheExtension) {
    const Light light = import(with_light(R"({"type": "spot"})")).scene.lights.at(0);
    EXPECT_EQ(light.intensity, glm::vec3(1));
    EXPECT_EQ(light.range, 0.0f);
    EXPECT_EQ(light.inner_cone_angle, 0.0f);
    EXPECT_FLOAT_EQ(light.outer_cone_angle, std::numbers::pi_v<float> / 4);
    EXPECT_EQ(import(with_light(R"({"type": "directional"})")).scene.lights.at(0).direction,
              glm::vec3(0, 0, -1));
}

TEST(GltfLights, RejectUnknownTypesAndImpossibleCones) {
    EXPECT_NE(import_error(with_light(R"({"type": "laser"})")).find("lights[0].type"), std::string::npos);
    EXPECT_NE(import_error(with_light(R"({"type": "spot", "spot": {"innerConeAngle": 1}})")).find("cone"),
              std::string::npos);
    GltfBuilder b = with_light(R"({"type": "point"})");
    b.json["nodes"][0]["extensions"]["KHR_lights_punctual"]["light"] = 1;
    EXPECT_NE(import_error(b).find("light 1 does not exist"), std::string::npos);
}

} // namespace
} // namespace ajar::test
