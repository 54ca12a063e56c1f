#include "unit/export/same_scene.hpp"

#include "export/export.hpp"
#include "import/import.hpp"

#include <algorithm>
#include <gtest/gtest.h>

namespace ajar::test {

namespace {

void expect_near(const glm::mat4& got, const glm::mat4& wanted, float tolerance, const std::string& what) {
    float size = 0;
    for (int c = 0; c < 4; ++c)
        for (int r = 0; r < 3; ++r) size = std::max(size, std::abs(wanted[c][r]));
    for (int c = 0; c < 4; ++c)
        for (int r = 0; r < 4; ++r)
            EXPECT_NEAR(got[c][r], wanted[c][r], tolerance * size)
                << what << ": column " << c << " row " << r;
}

void expect_near(const glm::vec3& got, const glm::vec3& wanted, float tolerance, const std::string& what) {
    EXPECT_LE(glm::length(got - wanted), tolerance * std::max(glm::length(wanted), 1e-20f)) << what;
}

void expect_same(const Mesh& got, const Mesh& wanted) {
    SCOPED_TRACE("mesh " + wanted.name);
    EXPECT_EQ(got.name, wanted.name);
    EXPECT_EQ(got.positions, wanted.positions);
    EXPECT_EQ(got.normals, wanted.normals);
    EXPECT_EQ(got.tangents, wanted.tangents);
    EXPECT_EQ(got.uv0, wanted.uv0);
    EXPECT_EQ(got.uv1, wanted.uv1);
    EXPECT_EQ(got.colors, wanted.colors);
    EXPECT_EQ(got.triangles, wanted.triangles);
    EXPECT_EQ(got.triangle_materials, wanted.triangle_materials);
}

void expect_same(const TextureUse& got, const TextureUse& wanted) {
    EXPECT_EQ(got.texture, wanted.texture);
    EXPECT_EQ(got.uv_set, wanted.uv_set);
    expect_near(got.uv_row_u, wanted.uv_row_u, 1e-6f, "u' of a texture");
    expect_near(got.uv_row_v, wanted.uv_row_v, 1e-6f, "v' of a texture");
}

void expect_same(const Material& got, const Material& wanted) {
    SCOPED_TRACE("material " + wanted.name);
    EXPECT_EQ(got.name, wanted.name);
    EXPECT_EQ(got.base_color, wanted.base_color);
    EXPECT_EQ(got.metallic, wanted.metallic);
    EXPECT_EQ(got.roughness, wanted.roughness);
    EXPECT_EQ(got.normal_scale, wanted.normal_scale);
    EXPECT_EQ(got.occlusion_strength, wanted.occlusion_strength);
    EXPECT_EQ(got.emission, wanted.emission);
    EXPECT_EQ(got.ior, wanted.ior);
    EXPECT_EQ(got.specular, wanted.specular);
    EXPECT_EQ(got.specular_color, wanted.specular_color);
    EXPECT_EQ(got.alpha_mode, wanted.alpha_mode);
    EXPECT_EQ(got.alpha_cutoff, wanted.alpha_cutoff);
    EXPECT_EQ(got.double_sided, wanted.double_sided);
    EXPECT_EQ(got.unlit, wanted.unlit);
    expect_same(got.base_color_texture, wanted.base_color_texture);
    expect_same(got.metallic_roughness_texture, wanted.metallic_roughness_texture);
    expect_same(got.normal_texture, wanted.normal_texture);
    expect_same(got.occlusion_texture, wanted.occlusion_texture);
    expect_same(got.emission_texture, wanted.emission_texture);
}

void expect_same(const Light& got, const Light& wanted) {
    SCOPED_TRACE("light " + wanted.name);
    EXPECT_EQ(got.name, wanted.name);
    EXPECT_EQ(got.kind, wanted.kind);
    EXPECT_EQ(got.intensity, wanted.intensity);
    if (wanted.kind != LightKind::directional) {
        EXPECT_EQ(got.position, wanted.position);
    }
    if (wanted.kind != LightKind::point) expect_near(got.direction, wanted.direction, 1e-6f, "direction");
    EXPECT_EQ(got.range, wanted.range);
    EXPECT_EQ(got.radius, wanted.radius);
    EXPECT_NEAR(got.angular_diameter, wanted.angular_diameter, 1e-6f * wanted.angular_diameter);
    if (wanted.kind != LightKind::spot) return;
    EXPECT_NEAR(got.inner_cone_angle, wanted.inner_cone_angle, 1e-6f);
    EXPECT_EQ(got.outer_cone_angle, wanted.outer_cone_angle);
}

} // namespace

Scene round_trip(const Scene& scene) { return import_gltf_memory(glb_bytes(scene), {}).scene; }

void expect_same(const Scene& got, const Scene& wanted, float tolerance) {
    EXPECT_EQ(got.name, wanted.name);
    ASSERT_EQ(got.meshes.size(), wanted.meshes.size());
    for (std::size_t i = 0; i < got.meshes.size(); ++i) expect_same(got.meshes[i], wanted.meshes[i]);
    ASSERT_EQ(got.instances.size(), wanted.instances.size());
    for (std::size_t i = 0; i < got.instances.size(); ++i) {
        const Instance &a = got.instances[i], &b = wanted.instances[i];
        EXPECT_EQ(a.name, b.name);
        EXPECT_EQ(a.mesh, b.mesh);
        expect_near(a.to_world, b.to_world, tolerance, b.name);
        EXPECT_NEAR(a.sphere_radius, b.sphere_radius, 1e-5f * b.sphere_radius);
    }
    ASSERT_EQ(got.materials.size(), wanted.materials.size());
    for (std::size_t i = 0; i < got.materials.size(); ++i) expect_same(got.materials[i], wanted.materials[i]);
    ASSERT_EQ(got.textures.size(), wanted.textures.size());
    for (std::size_t i = 0; i < got.textures.size(); ++i) {
        EXPECT_EQ(got.textures[i].name, wanted.textures[i].name);
        EXPECT_EQ(got.textures[i].image, wanted.textures[i].image);
        EXPECT_EQ(got.textures[i].wrap_u, wanted.textures[i].wrap_u);
        EXPECT_EQ(got.textures[i].wrap_v, wanted.textures[i].wrap_v);
        EXPECT_EQ(got.textures[i].filter, wanted.textures[i].filter);
    }
    ASSERT_EQ(got.images.size(), wanted.images.size());
    for (std::size_t i = 0; i < got.images.size(); ++i) {
        EXPECT_EQ(got.images[i].name, wanted.images[i].name);
        EXPECT_EQ(got.images[i].width, wanted.images[i].width);
        EXPECT_EQ(got.images[i].rgba, wanted.images[i].rgba);
    }
    ASSERT_EQ(got.lights.size(), wanted.lights.size());
    for (std::size_t i = 0; i < got.lights.size(); ++i) expect_same(got.lights[i], wanted.lights[i]);
    ASSERT_EQ(got.cameras.size(), wanted.cameras.size());
    for (std::size_t i = 0; i < got.cameras.size(); ++i) {
        EXPECT_EQ(got.cameras[i].name, wanted.cameras[i].name);
        EXPECT_EQ(got.cameras[i].kind, wanted.cameras[i].kind);
        EXPECT_EQ(got.cameras[i].yfov, wanted.cameras[i].yfov);
        EXPECT_EQ(got.cameras[i].ymag, wanted.cameras[i].ymag);
        expect_near(got.cameras[i].to_world, wanted.cameras[i].to_world, tolerance, "camera");
    }
}

} // namespace ajar::test
