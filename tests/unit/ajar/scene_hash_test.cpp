// The scene's hash: every field that can change an image enters, and nothing else does.
#include "ajar/scene_hash.hpp"

#include <functional>
#include <gtest/gtest.h>
#include <set>
#include <utility>
#include <vector>

namespace ajar::test {

namespace {

Scene small_scene() {
    Scene scene;
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.normals = {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}};
    mesh.triangles = {{0, 1, 2}};
    mesh.triangle_materials = {0};
    scene.meshes.push_back(mesh);
    scene.instances.emplace_back();
    scene.materials.emplace_back();
    scene.textures.emplace_back();
    scene.images.push_back({"image", 1, 1, {1, 2, 3, 4}});
    scene.lights.emplace_back();
    scene.cameras.emplace_back();
    return scene;
}

using Change = std::function<void(Scene&)>;

std::vector<Change> changes_of_geometry() {
    return {
        [](Scene& s) { s.meshes[0].positions[1].x = 2; },
        [](Scene& s) {
            s.meshes[0].normals[0] = {0, 1, 0};
        },
        [](Scene& s) {
            s.meshes[0].tangents.assign(3, {1, 0, 0, 1});
        },
        [](Scene& s) {
            s.meshes[0].uv0.assign(3, {0, 0});
        },
        [](Scene& s) {
            s.meshes[0].uv1.assign(3, {0, 0});
        },
        [](Scene& s) {
            s.meshes[0].colors.assign(3, {1, 1, 1, 1});
        },
        [](Scene& s) {
            s.meshes[0].triangles[0] = {0, 2, 1};
        },
        [](Scene& s) { s.meshes[0].triangle_materials[0] = 1; },
        [](Scene& s) { s.meshes.push_back(s.meshes[0]); },
        [](Scene& s) { s.instances[0].mesh = 1; },
        [](Scene& s) { s.instances[0].to_world[3].x = 1; },
    };
}

std::vector<Change> changes_of_materials() {
    std::vector<Change> changes{
        [](Scene& s) { s.materials[0].base_color.w = 0.5f; },
        [](Scene& s) { s.materials[0].metallic = 0.5f; },
        [](Scene& s) { s.materials[0].roughness = 0.5f; },
        [](Scene& s) { s.materials[0].normal_scale = 0.5f; },
        [](Scene& s) { s.materials[0].emission.y = 1; },
        [](Scene& s) { s.materials[0].ior = 1.4f; },
        [](Scene& s) { s.materials[0].specular = 0.5f; },
        [](Scene& s) { s.materials[0].specular_color.z = 0.5f; },
        [](Scene& s) { s.materials[0].alpha_mode = AlphaMode::mask; },
        [](Scene& s) { s.materials[0].alpha_cutoff = 0.4f; },
        [](Scene& s) { s.materials[0].double_sided = true; },
        [](Scene& s) { s.materials[0].unlit = true; },
        [](Scene& s) { s.textures[0].image = 1; },
        [](Scene& s) { s.textures[0].wrap_u = Wrap::clamp; },
        [](Scene& s) { s.textures[0].wrap_v = Wrap::clamp; },
        [](Scene& s) { s.textures[0].filter = TextureFilter::nearest; },
        [](Scene& s) { s.images[0].rgba[3] = 5; },
    };
    for (TextureUse Material::*use : {&Material::base_color_texture, &Material::metallic_roughness_texture,
                                      &Material::normal_texture, &Material::emission_texture}) {
        changes.push_back([use](Scene& s) { (s.materials[0].*use).texture = 0; });
        changes.push_back([use](Scene& s) { (s.materials[0].*use).uv_set = 1; });
        changes.push_back([use](Scene& s) { (s.materials[0].*use).uv_row_u.z = 1; });
        changes.push_back([use](Scene& s) { (s.materials[0].*use).uv_row_v.z = 1; });
    }
    return changes;
}

std::vector<Change> changes_of_lights_and_cameras() {
    return {
        [](Scene& s) { s.lights[0].kind = LightKind::spot; },
        [](Scene& s) { s.lights[0].intensity.x = 2; },
        [](Scene& s) { s.lights[0].position.x = 2; },
        [](Scene& s) {
            s.lights[0].direction = {1, 0, 0};
        },
        [](Scene& s) { s.lights[0].range = 2; },
        [](Scene& s) { s.lights[0].inner_cone_angle = 0.1f; },
        [](Scene& s) { s.lights[0].outer_cone_angle = 0.2f; },
        [](Scene& s) { s.lights[0].radius = 0.2f; },
        [](Scene& s) { s.lights[0].angular_diameter = 0.2f; },
        [](Scene& s) { s.instances[0].sphere_radius = 0.2f; },
        [](Scene& s) { s.instances[0].sphere_center.y = 0.2f; },
        [](Scene& s) { s.cameras[0].kind = CameraKind::orthographic; },
        [](Scene& s) { s.cameras[0].yfov = 1; },
        [](Scene& s) { s.cameras[0].ymag = 2; },
        [](Scene& s) { s.cameras[0].to_world[3].y = 1; },
        [](Scene& s) { s.camera = 1; },
        [](Scene& s) { s.environment.emplace(); },
        [](Scene& s) { s.environment.emplace().scale.x = 2; },
        [](Scene& s) { s.environment.emplace().rotation = 1; },
        [](Scene& s) {
            s.environment = Environment{"", 1, 1, {{1, 2, 3}}, {1, 1, 1}, 0};
        },
    };
}

} // namespace

TEST(SceneHash, EveryChangeOfAnImageChangesIt) {
    std::set<std::string> seen{scene_hash(small_scene())};
    std::size_t count = 1;
    for (const auto& changes :
         {changes_of_geometry(), changes_of_materials(), changes_of_lights_and_cameras()})
        for (const Change& change : changes) {
            Scene scene = small_scene();
            change(scene);
            seen.insert(scene_hash(scene));
            EXPECT_EQ(seen.size(), ++count);
            count = seen.size();
        }
}

TEST(SceneHash, NamesOfPartsDoNotEnter) {
    Scene scene = small_scene();
    scene.name = scene.meshes[0].name = scene.instances[0].name = scene.materials[0].name = "other";
    scene.textures[0].name = scene.images[0].name = scene.lights[0].name = "other";
    EXPECT_EQ(scene_hash(scene), scene_hash(small_scene()));
}

} // namespace ajar::test
