// A scene that is written and read again is the same scene.
#include "export/export.hpp"

#include "base/error.hpp"
#include "base/file.hpp"
#include "import/import.hpp"
#include "support/scene_builder.hpp"
#include "support/temporary_folder.hpp"
#include "unit/export/same_scene.hpp"

#include <algorithm>
#include <filesystem>
#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>
#include <limits>

namespace ajar::test {
namespace {

namespace fs = std::filesystem;

std::string error_of(const Scene& scene) {
    try {
        glb_bytes(scene);
    } catch (const Error& error) {
        return error.what();
    }
    return {};
}

// What has no name gets one when it is read.
Scene named(Scene scene) {
    for (Instance& instance : scene.instances) instance.name = "node";
    for (std::size_t i = 0; i < scene.lights.size(); ++i) scene.lights[i].name = "light" + std::to_string(i);
    for (std::size_t i = 0; i < scene.cameras.size(); ++i) scene.cameras[i].name = "eye" + std::to_string(i);
    return scene;
}

Scene one_box() {
    SceneBuilder builder;
    builder.box({0, 0, 0}, {1, 2, 3}, builder.material(plastic({0.5f, 0.25f, 0.125f}, 0.3f)));
    builder.perspective({4, 4, 4}, {0, 0, 0}, 0.7f);
    return named(builder.build());
}

TEST(Export, TheScenesComeBack) {
    int count = 0;
    for (const auto& folder : fs::directory_iterator(fs::path(AJAR_SOURCE_DIR) / "scenes")) {
        const fs::path file = folder.path() / (folder.path().filename().string() + ".gltf");
        if (!fs::exists(file)) continue;
        SCOPED_TRACE(file.string());
        const Scene scene = import_gltf(file).scene;
        expect_same(round_trip(scene), scene);
        ++count;
    }
    EXPECT_GE(count, 10);
}

TEST(Export, TheRealFilesComeBack) {
    const fs::path corpus = fs::path(AJAR_SOURCE_DIR).parent_path() / "shared" / "corpus";
    if (!fs::exists(corpus)) GTEST_SKIP() << "no corpus beside the project";
    for (const auto& entry : fs::recursive_directory_iterator(corpus)) {
        const fs::path file = entry.path();
        if (file.parent_path().filename() == "hostile") continue;
        if (file.extension() != ".gltf" && file.extension() != ".glb") continue;
        if (entry.file_size() > 500'000) continue; // PNGs of large textures take a minute
        SCOPED_TRACE(file.string());
        const Scene scene = import_gltf(file).scene;
        const Scene again = round_trip(scene); // without the vertices that no triangle has
        expect_same(round_trip(again), again, 1e-5f);
        EXPECT_EQ(again.instances.size(), scene.instances.size());
        EXPECT_EQ(again.images.size(), scene.images.size());
    }
}

TEST(Export, ASecondTripChangesNoByte) {
    const Scene once = round_trip(one_box());
    EXPECT_EQ(glb_bytes(once), glb_bytes(round_trip(once)));
}

TEST(Export, EveryMaterialComesBack) {
    Scene scene = one_box();
    scene.images.push_back({"texels", 2, 1, {255, 0, 0, 255, 0, 128, 7, 3}});
    scene.textures.push_back({"a", 0, Wrap::clamp, Wrap::mirror, TextureFilter::nearest});
    scene.textures.push_back({"b", 0, Wrap::repeat, Wrap::repeat, TextureFilter::linear});
    Material& m = scene.materials[0];
    m.base_color = {0.1f, 0.2f, 0.3f, 0.4f};
    m.base_color_texture.texture = 0;
    m.base_color_texture.uv_row_u = {0.5f, -1.5f, 0.25f}; // a rotation, and a scale in each direction
    m.base_color_texture.uv_row_v = {0.25f, 3.0f, -2};
    m.metallic = 0.75f;
    m.metallic_roughness_texture = {1, 1};
    m.normal_texture.texture = 0;
    m.normal_scale = 0.3f;
    m.occlusion_texture.texture = 1;
    m.occlusion_strength = 0.6f;
    m.emission = {3, 0.1f, 77};
    m.emission_texture.texture = 1;
    m.emission_texture.uv_row_u = {-1, 0, 0};
    m.ior = 1.2f;
    m.specular = 0.2f;
    m.specular_color = {2, 0.5f, 0};
    m.alpha_mode = AlphaMode::mask;
    m.alpha_cutoff = 0.7f;
    m.double_sided = true;
    m.unlit = true;
    m.name = "every \"thing\"";
    Mesh& mesh = scene.meshes[0];
    mesh.uv1 = mesh.uv0;
    mesh.colors.assign(mesh.positions.size(), {0.1f, 1, 0, 0.5f});
    mesh.tangents.assign(mesh.positions.size(), {0, 0.6f, 0.8f, -1});
    expect_same(round_trip(scene), scene);
}

TEST(Export, SharedVerticesOfTwoMaterialsAreCopied) {
    Scene scene = one_box();
    scene.materials.push_back(scene.materials[0]);
    Mesh& mesh = scene.meshes[0];
    for (std::size_t i = 0; i < mesh.triangles.size(); i += 2) mesh.triangle_materials[i] = 1;
    const Scene again = round_trip(scene);
    ASSERT_EQ(again.meshes[0].triangles.size(), mesh.triangles.size());
    EXPECT_EQ(again.meshes[0].triangle_materials, mesh.triangle_materials);
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
        for (int k = 0; k < 3; ++k)
            EXPECT_EQ(again.meshes[0].positions[again.meshes[0].triangles[i][k]],
                      mesh.positions[mesh.triangles[i][k]]);
}

TEST(Export, EveryPlacementComesBack) {
    Scene scene = one_box();
    const glm::mat4 turn = glm::rotate(glm::mat4(1), 1.1f, glm::normalize(glm::vec3(1, 2, -3)));
    const glm::mat4 other = glm::rotate(glm::mat4(1), 2.9f, glm::normalize(glm::vec3(-1, 0.2f, 0.4f)));
    const glm::mat4 stretch = glm::scale(glm::mat4(1), {2, 0.125f, 700});
    const glm::mat4 mirror = glm::scale(glm::mat4(1), {-1, 1, 1});
    const glm::mat4 half_turn = glm::rotate(glm::mat4(1), 3.14159265f, glm::vec3(0, 1, 0));
    for (const glm::mat4& place :
         {glm::translate(glm::mat4(1), {1, -2, 1e6f}), turn, half_turn, stretch, turn * stretch,
          turn * stretch * mirror, stretch * turn /* shears */, stretch * turn * mirror,
          other * stretch * turn * glm::scale(glm::mat4(1), {1, 30, 0.2f})})
        scene.instances.push_back({"node", 0, place});
    expect_same(round_trip(scene), scene);
}

TEST(Export, EveryLightAndCameraComesBack) {
    SceneBuilder builder;
    builder.box({0, 0, 0}, {1, 1, 1}, builder.material(lambert({1, 1, 1})));
    builder.point_light({1, 2, 3}, {0, 7.7f, 0.3f}, 0.25f);
    builder.spot_light({1, 2, 3}, glm::normalize(glm::vec3(1, -3, 0.1f)), {100, 1, 1}, 0.3f, 0.3f);
    builder.spot_light({1, 2, 3}, {0, -1, 0}, {0.1f, 0.2f, 0.3f}, 0.1f, 0.7f, 2);
    builder.directional_light(glm::normalize(glm::vec3(-1, -1, 5)), {1e-3f, 1e5f, 1}, 0.01f);
    builder.perspective({3, 2, 1}, {0, 0, 0}, 0.4f);
    builder.orthographic({3, 2, 1}, {0, 0.5f, 0}, 3);
    Scene scene = named(builder.build());
    scene.lights[0].range = 17;
    expect_same(round_trip(scene), scene);
}

TEST(Export, WhatGltfCannotSayIsSaid) {
    Scene scene = one_box();
    scene.environment.emplace();
    scene.meshes[0].colors.assign(scene.meshes[0].positions.size(), {2, 0.5f, -1, 1});
    std::vector<std::string> lines;
    const auto bytes = glb_bytes(scene, {"", [&](std::string_view line) { lines.emplace_back(line); }});
    ASSERT_EQ(lines.size(), 2u);
    EXPECT_NE(lines[0].find("vertex colours"), std::string::npos);
    EXPECT_NE(lines[1].find("environment"), std::string::npos);
    EXPECT_EQ(import_gltf_memory(bytes, {}).scene.meshes[0].colors[0], glm::vec4(1, 0.5f, 0, 1));
}

TEST(Export, AShearedTextureIsAnError) {
    Scene scene = one_box();
    scene.images.push_back({"", 1, 1, {1, 2, 3, 255}});
    scene.textures.emplace_back();
    scene.materials[0].base_color_texture.texture = 0;
    scene.materials[0].base_color_texture.uv_row_u = {1, 0.5f, 0};
    EXPECT_NE(error_of(scene).find("sheared"), std::string::npos);
}

TEST(Export, AnInvalidSceneIsAnError) {
    Scene scene = one_box();
    scene.meshes[0].positions[0].x = std::numeric_limits<float>::quiet_NaN();
    EXPECT_NE(error_of(scene).find("not finite"), std::string::npos);
}

TEST(Export, AnEmptySceneIsAFile) {
    const Scene again = round_trip(Scene{});
    EXPECT_TRUE(again.instances.empty());
}

TEST(Export, NamesThatAreNoTextDoNoHarm) {
    Scene scene = one_box();
    scene.instances[0].name = "a\xff\xfe\n\"";
    EXPECT_EQ(round_trip(scene).instances.size(), 1u);
}

TEST(Export, WritesGlbFilesOnly) {
    const TemporaryFolder folder;
    const Scene scene = one_box();
    export_gltf(folder / "a.glb", scene);
    EXPECT_EQ(read_file(folder / "a.glb"), glb_bytes(scene));
    EXPECT_THROW(export_gltf(folder / "a.gltf", scene), Error);
    EXPECT_THROW(check_export_name(folder / "nowhere" / "a.glb"), Error);
}

TEST(Export, LargeMeshesGetWideIndices) {
    SceneBuilder builder; // 20 * 4^7 triangles, 163,842 vertices
    builder.sphere({0, 0, 0}, 1, 7, Normals::smooth, builder.material(lambert({1, 1, 1})));
    builder.perspective({4, 4, 4}, {0, 0, 0}, 0.7f);
    const Scene scene = named(builder.build());
    ASSERT_GT(scene.meshes[0].positions.size(), 65536u);
    expect_same(round_trip(scene), scene);
}

} // namespace
} // namespace ajar::test
