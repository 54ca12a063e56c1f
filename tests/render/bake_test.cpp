// What is baked has a closed form: a furnace room's series, an open sky, a form factor.
#include "bake/bake.hpp"

#include "base/error.hpp"
#include "render_test.hpp"

#include <cmath>
#include <glm/gtc/constants.hpp>

namespace ajar::test {
namespace {

class Bake : public RenderTest {
  protected:
    BakeOutput bake(const Scene& scene, const BakeSettings& settings) {
        return ajar::bake(device(), scene, settings, {}, {});
    }
    std::string error_of(const Scene& scene, const BakeSettings& settings) {
        try {
            bake(scene, settings);
        } catch (const Error& error) {
            return error.what();
        }
        return {};
    }
};

BakeSettings few(const std::string& to) {
    BakeSettings settings;
    settings.to = to;
    settings.side = 64;
    settings.patches = 300;
    settings.render.samples = 64;
    return settings;
}

// All of a room glows with radiance e and reflects a share a: everywhere e / (1 - a), irradiance pi times it.
Scene furnace_room(float a, float e) {
    SceneBuilder builder;
    builder.room({0, 0, 0}, {1, 2, 3}, builder.material(glowing_lambert(glm::vec3(a), glm::vec3(e))));
    builder.perspective({0.5f, 0.5f, 0.5f}, {0.5f, 0.5f, 0}, 1);
    return builder.build();
}

TEST_F(Bake, AFurnaceRoomIsItsSeriesInVertexColours) {
    BakeSettings settings = few("vertices");
    settings.render.max_bounces = 60;
    const BakeOutput output = bake(furnace_room(0.5f, 0.25f), settings);
    double sum = 0;
    const std::vector<glm::vec4>& colors = output.scene.meshes[0].colors;
    for (const glm::vec4& color : colors) sum += color.x;
    // 300 patches of 64 paths whose sum of surviving bounces varies by less than its mean.
    EXPECT_NEAR(sum / static_cast<double>(colors.size()), 0.5, 4 * 0.5 / std::sqrt(300.0 * 64));
    EXPECT_GE(output.stats.elements, 300u);
    EXPECT_LT(output.stats.elements, 310u);
    EXPECT_EQ(output.stats.clipped, 0);
}

TEST_F(Bake, AFurnaceRoomIsItsSeriesInALightmap) {
    BakeSettings settings = few("lightmap");
    settings.render.max_bounces = 60;
    settings.render.samples = 16;
    const BakeOutput output = bake(furnace_room(0.5f, 0.25f), settings);
    ASSERT_TRUE(output.irradiance);
    const std::vector<float>& pixels = output.irradiance->find("")->pixels;
    double sum = 0;
    for (std::size_t i = 0; i < pixels.size(); i += 4) sum += pixels[i];
    EXPECT_NEAR(sum / (64 * 64), glm::pi<double>() * 0.5, 0.03);
    ASSERT_EQ(output.scene.images.size(), 1u);
    double bytes = 0;
    const std::vector<std::uint8_t>& rgba = output.scene.images[0].rgba;
    for (std::size_t i = 0; i < rgba.size(); i += 4) bytes += rgba[i];
    EXPECT_NEAR(bytes / (64 * 64), 188, 3); // sRGB of a half
}

TEST_F(Bake, OcclusionIsTheShareOfSkyThatIsOpen) {
    SceneBuilder builder; // a wall at the edge of a floor: the half of the sky is open just before it
    const std::uint32_t grey = builder.material(lambert({0.5f, 0.5f, 0.5f}));
    builder.quad({-1, 0, 0}, {-1, 0, 1}, {1, 0, 1}, {1, 0, 0}, grey);
    builder.quad({-50, 0, 0}, {50, 0, 0}, {50, 100, 0}, {-50, 100, 0}, grey);
    builder.perspective({0, 1, 5}, {0, 0, 0}, 1);
    BakeSettings settings = few("occlusion");
    settings.side = 1024; // the floor has some of it
    settings.render.samples = 16;
    settings.render.ao_distance = 1e3f;
    const BakeOutput output = bake(builder.build(), settings);
    const Material& m = output.scene.materials[0];
    ASSERT_TRUE(m.occlusion_texture.used());
    EXPECT_FALSE(m.unlit);
    // A wall without end before a place on the floor hides half of the cosine-weighted sky.
    const Mesh& floor = output.scene.meshes[0];
    const TextureImage& image = output.scene.images.back();
    glm::vec2 middle(0);
    for (const glm::vec2& uv : floor.uv1) middle += uv / static_cast<float>(floor.uv1.size());
    double sum = 0;
    for (int j = -3; j <= 3; ++j)
        for (int i = -3; i <= 3; ++i) {
            const auto x = static_cast<std::uint32_t>(middle.x * 1024 + static_cast<float>(i));
            const auto y = static_cast<std::uint32_t>(middle.y * 1024 + static_cast<float>(j));
            sum += image.rgba[4 * (x + std::size_t{1024} * y)] / 255.0;
        }
    EXPECT_NEAR(sum / 49, 0.5, 4 * 0.5 / std::sqrt(49.0 * 16));
}

TEST_F(Bake, GivesTheSameSceneWhateverThePool) {
    BakeSettings settings = few("lightmap");
    settings.render.samples = 4;
    const Scene scene = furnace_room(0.5f, 0.25f);
    const BakeOutput a = bake(scene, settings);
    settings.render.pool_paths = 2000;
    settings.render.segment_paths = 64;
    const BakeOutput b = bake(scene, settings);
    EXPECT_EQ(a.scene.images[0].rgba, b.scene.images[0].rgba);
    EXPECT_EQ(a.irradiance->find("")->pixels, b.irradiance->find("")->pixels);
}

TEST_F(Bake, WithoutLightTrianglesOrAreaIsAnError) {
    SceneBuilder dark;
    dark.square({0, 0, 0}, {0, 0, 1}, 1, dark.material(lambert({1, 1, 1})));
    dark.perspective({0, 0, 3}, {0, 0, 0}, 1);
    Scene scene = dark.build();
    for (const char* to : {"vertices", "lightmap"})
        EXPECT_NE(error_of(scene, few(to)).find("there is no light to bake"), std::string::npos);
    EXPECT_EQ(error_of(scene, few("occlusion")), "");
    BakeSettings sky = few("vertices");
    sky.render.background[1] = 1;
    EXPECT_EQ(error_of(scene, sky), "");
    scene.lights.emplace_back();
    for (glm::vec3& p : scene.meshes[0].positions) p = {1, 1, 1};
    for (const char* to : {"vertices", "lightmap", "occlusion"})
        EXPECT_NE(error_of(scene, few(to)).find("has any area"), std::string::npos) << to;
    scene.instances.clear();
    for (const char* to : {"vertices", "lightmap", "occlusion"})
        EXPECT_NE(error_of(scene, few(to)).find("there are no triangles"), std::string::npos) << to;
    EXPECT_NE(error_of(furnace_room(0.5f, 1), few("nonsense")).find("vertices, lightmap"), std::string::npos);
}

} // namespace
} // namespace ajar::test
