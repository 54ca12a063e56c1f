// The scene's own functions: validation, bounds, the framing camera, light.
#include "scene/scene.hpp"

#include "base/error.hpp"

#include <gtest/gtest.h>

namespace ajar {
namespace {

Scene one_triangle() {
    Scene scene;
    Mesh mesh;
    mesh.name = "shape";
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.normals.assign(3, {0, 0, 1});
    mesh.triangles = {{0, 1, 2}};
    mesh.triangle_materials = {0};
    scene.meshes.push_back(mesh);
    scene.materials.emplace_back();
    scene.instances.push_back({"node", 0, glm::mat4(1)});
    return scene;
}

std::string complaint(const Scene& scene) {
    try {
        validate(scene);
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

TEST(SceneValidation, AcceptsATriangleAndAnEmptyScene) {
    EXPECT_EQ(complaint(one_triangle()), "");
    EXPECT_EQ(complaint(Scene{}), "");
}

TEST(SceneValidation, NamesWhatIsOutOfRange) {
    Scene scene = one_triangle();
    scene.meshes[0].triangles[0].z = 3;
    EXPECT_NE(complaint(scene).find("mesh 0 'shape': triangle 0: vertex index out of range"),
              std::string::npos);
    scene = one_triangle();
    scene.meshes[0].triangle_materials[0] = 1;
    EXPECT_NE(complaint(scene).find("material 1 does not exist"), std::string::npos);
    scene = one_triangle();
    scene.instances[0].mesh = 1;
    EXPECT_NE(complaint(scene).find("mesh 1 does not exist"), std::string::npos);
    scene = one_triangle();
    scene.materials[0].normal_texture.texture = 0;
    EXPECT_NE(complaint(scene).find("texture 0 does not exist"), std::string::npos);
    scene = one_triangle();
    scene.textures.emplace_back();
    EXPECT_NE(complaint(scene).find("image 0 does not exist"), std::string::npos);
}

TEST(SceneValidation, NamesAttributesOfTheWrongLength) {
    Scene scene = one_triangle();
    scene.meshes[0].normals.pop_back();
    EXPECT_NE(complaint(scene).find("2 normals for 3 positions"), std::string::npos);
    scene = one_triangle();
    scene.meshes[0].uv1.resize(1);
    EXPECT_NE(complaint(scene).find("set 1"), std::string::npos);
    scene = one_triangle();
    scene.images.push_back({"image", 2, 2, std::vector<std::uint8_t>(15)});
    EXPECT_NE(complaint(scene).find("15 bytes for 2 x 2 texels"), std::string::npos);
}

TEST(SceneValidation, NamesNumbersThatAreNotFinite) {
    Scene scene = one_triangle();
    scene.meshes[0].positions[1].y = NAN;
    EXPECT_NE(complaint(scene).find("position 1 is not finite"), std::string::npos);
    scene = one_triangle();
    scene.instances[0].to_world[3].x = INFINITY;
    EXPECT_NE(complaint(scene).find("transform is not finite"), std::string::npos);
    scene = one_triangle();
    scene.instances[0].to_world[0].x = 2e18f;
    EXPECT_NE(complaint(scene).find("too far"), std::string::npos);
    scene = one_triangle();
    scene.materials[0].emission.x = INFINITY;
    EXPECT_NE(complaint(scene).find("a factor is not finite"), std::string::npos);
}

TEST(SceneBounds, HoldEveryInstance) {
    Scene scene = one_triangle();
    scene.instances.push_back({"far", 0,
                               glm::mat4(glm::vec4(-2, 0, 0, 0), glm::vec4(0, 1, 0, 0), glm::vec4(0, 0, 1, 0),
                                         glm::vec4(10, 0, 5, 1))});
    const Bounds bounds = scene_bounds(scene);
    EXPECT_EQ(bounds.lower, glm::vec3(0, 0, 0));
    EXPECT_EQ(bounds.upper, glm::vec3(10, 1, 5));
    EXPECT_TRUE(scene_bounds(Scene{}).empty());
}

TEST(FramingCamera, SeesEveryCornerOfTheSceneAtAnyAspect) {
    for (const float aspect : {0.25f, 1.0f, 2.5f}) {
        Scene scene = one_triangle();
        scene.instances[0].to_world[0] = {40, 0, 0, 0};
        scene.instances[0].to_world[3] = {100, -3, 7, 1};
        const Camera camera = framing_camera(scene, aspect);
        const glm::mat4 to_camera = glm::inverse(camera.to_world);
        const float limit = std::tan(camera.yfov / 2);
        for (const glm::vec3& p : scene.meshes[0].positions) {
            const glm::vec3 q(to_camera * scene.instances[0].to_world * glm::vec4(p, 1));
            ASSERT_LT(q.z, 0);
            EXPECT_LE(std::abs(q.y / q.z), limit);
            EXPECT_LE(std::abs(q.x / q.z), limit * aspect);
        }
        EXPECT_NEAR(glm::determinant(glm::mat3(camera.to_world)), 1, 1e-5f);
    }
}

TEST(FramingCamera, CopesWithAnEmptySceneAndAPoint) {
    EXPECT_TRUE(std::isfinite(framing_camera(Scene{}, 1).to_world[3].x));
    Scene scene = one_triangle();
    scene.instances[0].to_world = glm::mat4(0);
    scene.instances[0].to_world[3] = {1, 2, 3, 1};
    EXPECT_TRUE(std::isfinite(framing_camera(scene, 1).to_world[3].x));
}

TEST(SceneLight, IsWhatAPlacedUnlitTriangleBrings) {
    Scene scene = one_triangle();
    scene.materials.emplace_back().unlit = true; // of no triangle
    EXPECT_FALSE(has_light(scene));
    scene.meshes[0].triangle_materials[0] = 1;
    EXPECT_TRUE(has_light(scene));
    scene.instances.clear();
    EXPECT_FALSE(has_light(scene));
}

TEST(SceneLight, IsALightAnEnvironmentOrAPlacedEmitter) {
    Scene scene = one_triangle();
    EXPECT_FALSE(has_light(scene));
    scene.materials.emplace_back().emission = {1, 0, 0}; // of no triangle
    EXPECT_FALSE(has_light(scene));
    scene.meshes[0].triangle_materials[0] = 1;
    EXPECT_TRUE(has_light(scene));
    scene.instances.clear();
    EXPECT_FALSE(has_light(scene));
    scene.lights.emplace_back().intensity = {0, 0, 0};
    EXPECT_FALSE(has_light(scene));
    scene.lights[0].intensity.y = 1;
    EXPECT_TRUE(has_light(scene));
    scene.lights.clear();
    scene.environment.emplace();
    EXPECT_TRUE(has_light(scene));
    scene.environment->scale = {0, 0, 0};
    EXPECT_FALSE(has_light(scene));
}

TEST(SceneMemory, CountsArrays) {
    Scene scene = one_triangle();
    const std::uint64_t before = memory_bytes(scene);
    scene.images.push_back({"image", 2, 2, std::vector<std::uint8_t>(16)});
    EXPECT_EQ(memory_bytes(scene), before + 16);
    scene.meshes[0].tangents.resize(3);
    EXPECT_EQ(memory_bytes(scene), before + 16 + 3 * 16);
}

} // namespace
} // namespace ajar
