// From scene to baked scene on the host: what is handed to the device as elements, and what is made of the
// light that comes back.
#include "bake/lightmap.hpp"
#include "bake/texture_lookup.hpp"
#include "bake/unlit.hpp"
#include "bake/vertex_colors.hpp"
#include "image/srgb.hpp"
#include "unit/bake/shapes.hpp"

#include <algorithm>
#include <glm/gtc/constants.hpp>
#include <gtest/gtest.h>
#include <set>

namespace ajar::test {
namespace {

constexpr float PI = glm::pi<float>();

// A corner's place in the world.
glm::vec3 place(const Scene& scene, const Instance& instance, std::uint32_t vertex) {
    return glm::vec3(instance.to_world * glm::vec4(scene.meshes[instance.mesh].positions[vertex], 1));
}

double area(const Scene& scene) {
    double sum = 0;
    for (const PlacedTriangle& t : placed_triangles(scene))
        sum += 0.5 * glm::length(glm::cross(t.corners[1] - t.corners[0], t.corners[2] - t.corners[0]));
    return sum;
}

// Where an element's points lie: three of its corners, moved into the triangle.
glm::vec3 element_place(const Scene& scene, const SceneElement& e, glm::vec2 at) {
    const Instance& instance = scene.instances[e.instance];
    const glm::uvec3& t = scene.meshes[instance.mesh].triangles[e.triangle];
    const glm::vec2 uv = e.origin + at.x * e.edge_a + at.y * e.edge_b;
    return (1 - uv.x - uv.y) * place(scene, instance, t.x) + uv.x * place(scene, instance, t.y) +
           uv.y * place(scene, instance, t.z);
}

// Light on elements whose materials are Lambert's.
ElementLight lit(const Scene& scene, const std::vector<SceneElement>& elements, const glm::vec3& irradiance) {
    ElementLight light;
    light.irradiance.assign(elements.size(), irradiance);
    light.textures = texture_means(scene, elements);
    for (std::size_t i = 0; i < elements.size(); ++i) {
        const Mesh& mesh = scene.meshes[scene.instances[elements[i].instance].mesh];
        const Material& m = scene.materials[mesh.triangle_materials[elements[i].triangle]];
        light.materials.emission.push_back(m.emission);
        light.materials.reflectance.push_back(glm::vec3(m.base_color) * light.textures[i].color);
    }
    return light;
}

TEST(PatchElements, LieWhereTheirPatchesLie) {
    for (const auto& [name, scene] : awkward_scenes()) {
        SCOPED_TRACE(name);
        const PatchMesh mesh = PatchMesh::subdivide(scene, {0, 3000});
        const std::vector<SceneElement> elements = patch_elements(scene, mesh);
        ASSERT_EQ(elements.size(), mesh.patches.size());
        for (std::size_t p = 0; p < elements.size(); ++p) {
            EXPECT_EQ(elements[p].flags, 0u); // a triangle, its front
            const glm::vec2 corners[] = {{0, 0}, {1, 0}, {0, 1}};
            for (std::size_t k = 0; k < 3; ++k) {
                const glm::vec3 wanted = mesh.positions[mesh.patches[p].vertices[k]];
                EXPECT_LT(glm::length(element_place(scene, elements[p], corners[k]) - wanted),
                          1e-5f * (1 + glm::length(wanted)));
            }
        }
    }
}

TEST(Unwrapped, IsTheSameSurfaceOnItsAtlas) {
    for (const auto& [name, scene] : awkward_scenes()) {
        SCOPED_TRACE(name);
        const Atlas atlas = make_atlas(make_charts(placed_triangles(scene)), 256);
        const Scene again = unwrapped_scene(scene, atlas);
        EXPECT_NO_THROW(validate(again));
        EXPECT_NEAR(area(again), area(scene), 1e-9 * area(scene));
        ASSERT_EQ(again.instances.size(), scene.instances.size());
        std::set<std::uint32_t> meshes;
        for (const Instance& instance : again.instances) meshes.insert(instance.mesh);
        EXPECT_EQ(meshes.size(), again.instances.size()) << "each has light of its own";
        for (const Mesh& mesh : again.meshes) {
            ASSERT_EQ(mesh.uv1.size(), mesh.positions.size());
            for (const glm::vec2& uv : mesh.uv1) {
                EXPECT_GT(std::min(uv.x, uv.y), 0);
                EXPECT_LT(std::max(uv.x, uv.y), 1);
            }
        }
    }
}

// A wall with a texture of two texels, red and half transparent blue, lit by `irradiance`.
Scene textured_wall() {
    SceneBuilder builder;
    const std::uint32_t texture =
        builder.texture(2, 1, {255, 0, 0, 255, 0, 0, 255, 128}, TextureFilter::nearest);
    Material m = lambert({0.5f, 1, 1});
    m.base_color_texture.texture = texture;
    m.name = "wall";
    builder.quad({0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}, builder.material(m));
    builder.point_light({1, 1, 1}, {1, 1, 1});
    builder.perspective({1, 1, 3}, {1, 0, 0}, 1);
    return builder.build();
}

TEST(VertexColors, TimesTheTextureAreTheRadiance) {
    const Scene scene = textured_wall();
    const PatchMesh mesh = PatchMesh::subdivide(scene, {0, 100});
    const std::vector<SceneElement> elements = patch_elements(scene, mesh);
    const ElementLight light = lit(scene, elements, glm::vec3(PI, 2 * PI, PI / 4));
    Brightness brightness;
    const Scene baked = vertex_colored_scene(scene, mesh, light, 0, brightness);
    validate(baked);
    EXPECT_TRUE(baked.lights.empty());
    EXPECT_EQ(baked.cameras.size(), 1u);
    ASSERT_EQ(baked.materials.size(), 1u);
    EXPECT_EQ(baked.materials[0].name, "wall");
    EXPECT_TRUE(baked.materials[0].unlit);
    EXPECT_TRUE(baked.materials[0].base_color_texture.used());
    EXPECT_EQ(baked.images.size(), 1u);
    EXPECT_NEAR(area(baked), 2, 1e-6);
    // Where there is red, its factor times the light; likewise blue. What the texture lacks does not matter.
    const Mesh& wall = baked.meshes[0];
    for (std::size_t v = 0; v < wall.positions.size(); ++v) {
        if (wall.positions[v].x < 0.9f) {
            EXPECT_NEAR(wall.colors[v].x, 0.5f, 1e-5f);
        }
        if (wall.positions[v].x > 1.1f) {
            EXPECT_NEAR(wall.colors[v].z, 0.25f, 1e-5f);
        }
        EXPECT_NEAR(wall.uv0[v].x, 0.5f * wall.positions[v].x, 1e-6f);
        EXPECT_EQ(wall.normals[v], glm::vec3(0, 0, 1));
    }
    EXPECT_EQ(brightness.clipped_share(), 0);
}

TEST(VertexColors, AreScaledByExposureAndCut) {
    SceneBuilder builder;
    builder.square({0, 0, 0}, {0, 0, 1}, 1,
                   builder.material(glowing_lambert({0.5f, 0.5f, 0.5f}, {0, 0.1f, 5})));
    builder.perspective({0, 0, 3}, {0, 0, 0}, 1);
    const Scene scene = builder.build();
    const PatchMesh mesh = PatchMesh::subdivide(scene, {0, 2});
    const std::vector<SceneElement> elements = patch_elements(scene, mesh);
    const ElementLight light = lit(scene, elements, glm::vec3(8 * PI, PI, PI));
    Brightness brightness;
    const Scene baked = vertex_colored_scene(scene, mesh, light, -1, brightness);
    for (const glm::vec4& color : baked.meshes[0].colors) {
        EXPECT_EQ(color.x, 1); // half of 4
        EXPECT_NEAR(color.y, 0.5f * (0.5f + 0.1f), 1e-6f);
        EXPECT_EQ(color.z, 1);
    }
    EXPECT_EQ(brightness.clipped_share(), 1);
    EXPECT_NEAR(brightness.stops_too_bright(), 1, 1e-6);
}

TEST(VertexColors, OfMirroredInstancesFaceAsTheyDid) {
    SceneBuilder builder;
    builder.sphere({0, 0, 0}, 1, 2, Normals::smooth, builder.material(lambert({1, 1, 1})));
    builder.perspective({0, 0, 3}, {0, 0, 0}, 1);
    Scene scene = builder.build();
    scene.instances[0].to_world[0].x = -1;
    const PatchMesh mesh = PatchMesh::subdivide(scene, {0, 1000});
    const std::vector<SceneElement> elements = patch_elements(scene, mesh);
    Brightness brightness;
    const Scene baked = vertex_colored_scene(scene, mesh, lit(scene, elements, glm::vec3(0)), 0, brightness);
    const Mesh& ball = baked.meshes[0];
    for (const glm::uvec3& t : ball.triangles) {
        const glm::vec3 a = ball.positions[t.x];
        EXPECT_GT(glm::dot(glm::cross(ball.positions[t.y] - a, ball.positions[t.z] - a), a), 0) << "outwards";
        EXPECT_GT(glm::dot(ball.normals[t.x], a), 0.9f);
    }
}

TEST(Lightmap, HoldsRadianceAndAlphaAndTheImageIrradiance) {
    const Scene scene = [] {
        Scene s = textured_wall();
        s.materials[0].alpha_mode = AlphaMode::blend;
        return s;
    }();
    constexpr std::uint32_t side = 64;
    const Atlas atlas = make_atlas(make_charts(placed_triangles(scene)), side);
    const std::vector<CoveredTexel> covered = covered_texels(atlas);
    const std::vector<SceneElement> elements = texel_elements(atlas, covered);
    const ElementLight light = lit(scene, elements, glm::vec3(PI, PI / 2, PI / 4));
    Brightness brightness;
    const Scene baked = lightmapped_scene(unwrapped_scene(scene, atlas), side, covered, light, 0, brightness);
    validate(baked);
    ASSERT_EQ(baked.images.size(), 1u);
    ASSERT_EQ(baked.textures.size(), 1u);
    EXPECT_EQ(baked.materials[0].base_color_texture.uv_set, 1u);
    EXPECT_EQ(baked.materials[0].alpha_mode, AlphaMode::blend);
    // Looked up as a viewer would, away from the border between the texture's two texels.
    const TextureLookup lookup(baked);
    const Mesh& wall = baked.meshes[0];
    for (std::size_t v = 0; v < wall.positions.size(); ++v) {
        const glm::vec4 seen = lookup.color(baked.materials[0].base_color_texture, {}, wall.uv1[v]);
        const bool red = wall.positions[v].x < 1;
        EXPECT_NEAR(seen.x, red ? 0.5f : 0.0f, 0.005f);
        EXPECT_NEAR(seen.y, 0, 0.005f);
        EXPECT_NEAR(seen.z, red ? 0.0f : 0.25f, 0.005f);
        EXPECT_NEAR(seen.w, red ? 1.0f : 128.0f / 255, 0.005f);
    }
    const Image image = irradiance_image(side, covered, light.irradiance);
    const Layer& layer = *image.find("");
    for (std::size_t i = 0; i < image.pixel_count(); ++i) {
        EXPECT_NEAR(layer.pixels[4 * i], PI, 1e-5f); // the gutter is filled as well
        EXPECT_EQ(layer.pixels[4 * i + 3], 1);
    }
}

TEST(Occlusion, LeavesTheTexturesTheirCoordinates) {
    Scene scene = textured_wall();
    Mesh& mesh = scene.meshes[0];
    mesh.uv1 = mesh.uv0;
    for (glm::vec2& uv : mesh.uv1) uv += 5.0f;
    const Atlas atlas = make_atlas(make_charts(placed_triangles(scene)), 64);
    const std::vector<CoveredTexel> covered = covered_texels(atlas);
    const std::vector<glm::vec3> open(covered.size(), glm::vec3(0.25f));
    for (const std::uint32_t set : {0u, 1u}) {
        scene.materials[0].base_color_texture.uv_set = set;
        std::vector<std::string> without;
        const Scene baked =
            occluded_scene(unwrapped_scene_with_textures(scene, atlas, without), 64, covered, open);
        validate(baked);
        EXPECT_TRUE(without.empty());
        const Material& m = baked.materials[0];
        EXPECT_EQ(m.base_color_texture.uv_set, 0u);
        EXPECT_EQ(m.occlusion_texture.uv_set, 1u);
        EXPECT_EQ(m.base_color, scene.materials[0].base_color);
        EXPECT_FALSE(m.unlit);
        EXPECT_EQ(baked.lights.size(), 1u);
        for (std::size_t v = 0; v < baked.meshes[0].positions.size(); ++v) {
            EXPECT_NEAR(baked.meshes[0].uv0[v].x, 0.5f * baked.meshes[0].positions[v].x + (set == 1 ? 5 : 0),
                        1e-5f);
            EXPECT_LT(baked.meshes[0].uv1[v].x, 1);
        }
        EXPECT_EQ(baked.images.back().rgba[0], 64); // a quarter of 255
    }
    scene.materials[0].emission_texture = {0, 0};
    std::vector<std::string> without;
    const Scene baked =
        occluded_scene(unwrapped_scene_with_textures(scene, atlas, without), 64, covered, open);
    EXPECT_EQ(without, std::vector<std::string>{"wall"});
    EXPECT_FALSE(baked.materials[0].occlusion_texture.used());
    EXPECT_GT(baked.meshes[0].uv1[0].x, 4);
}

TEST(TextureLookup, WrapsAsTheDeviceDoes) {
    Scene scene;
    scene.images.push_back({"", 4, 1, {0, 0, 0, 0, 85, 0, 0, 51, 170, 0, 0, 102, 255, 0, 0, 153}});
    scene.textures.push_back({"", 0, Wrap::repeat, Wrap::clamp, TextureFilter::linear});
    const TextureLookup lookup(scene);
    const auto alpha = [&](float u, Wrap wrap, TextureFilter filter) {
        scene.textures[0].wrap_u = wrap;
        scene.textures[0].filter = filter;
        return lookup.color({0, 0}, {u, 0.5f}, {}).w;
    };
    const auto linear = TextureFilter::linear, nearest = TextureFilter::nearest;
    EXPECT_NEAR(alpha(0.25f, Wrap::repeat, linear), 0.1f, 1e-6f); // between the first two
    EXPECT_NEAR(alpha(0, Wrap::repeat, linear), 0.3f, 1e-6f);     // between the last and the first
    EXPECT_NEAR(alpha(1.25f, Wrap::repeat, linear), 0.1f, 1e-6f);
    EXPECT_NEAR(alpha(-0.5f, Wrap::clamp, linear), 0, 1e-6f);
    EXPECT_NEAR(alpha(1.5f, Wrap::clamp, linear), 0.6f, 1e-6f);
    EXPECT_NEAR(alpha(1.25f, Wrap::mirror, linear), 0.5f, 1e-6f); // as at 0.75
    EXPECT_NEAR(alpha(-0.25f, Wrap::mirror, linear), 0.1f, 1e-6f);
    EXPECT_NEAR(alpha(0.49f, Wrap::repeat, nearest), 0.2f, 1e-6f);
    EXPECT_NEAR(alpha(1e30f, Wrap::repeat, nearest), 0, 1e-6f); // any place, but one
    scene.textures[0].filter = nearest;
    EXPECT_NEAR(lookup.color({0, 0}, {0.3f, 0}, {}).x, srgb_decode(85.0f / 255), 1e-6f);
    EXPECT_EQ(lookup.color({}, {0.3f, 0}, {}), glm::vec4(1));
}

TEST(ViewDependentMaterials, AreThoseInUseThatReflect) {
    SceneBuilder builder;
    Material shiny = plastic({1, 1, 1}, 0.5f);
    shiny.name = "shiny";
    builder.square({0, 0, 0}, {0, 0, 1}, 1, builder.material(shiny));
    builder.square({0, 0, 1}, {0, 0, 1}, 1, builder.material(lambert({1, 1, 1})));
    builder.material(metal({1, 1, 1}, 0.5f)); // on no triangle
    builder.perspective({0, 0, 3}, {0, 0, 0}, 1);
    EXPECT_EQ(view_dependent_materials(builder.build()), std::vector<std::string>{"shiny"});
}

} // namespace
} // namespace ajar::test
