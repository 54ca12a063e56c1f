// Emissive triangles: sides, textures and alpha, whichever way they are sampled.
#include "light_functions.hpp"

#include <cmath>

namespace ajar::test {
namespace {

using namespace shared;

class TriangleEmission : public LightFunctions, public testing::WithParamInterface<std::uint32_t> {};
INSTANTIATE_TEST_SUITE_P(Sampled, TriangleEmission, testing::Values(0u, FEATURE_WIDE_TRIANGLES),
                         [](const auto& row) { return row.param == 0 ? "ByArea" : "BySolidAngle"; });

TEST_P(TriangleEmission, EmitsFromItsFrontAloneUnlessTwoSided) {
    Lighting lighting;
    lighting.features = GetParam();
    lighting.triangles = {triangle({-1, 1, -1}, {1, 1, -1}, {0, 1, 1}, 5),
                          triangle({-1, 1, -1}, {1, 1, -1}, {0, 1, 1}, 5)};
    lighting.triangles[1].two_sided = true;
    for (const std::uint32_t light : {0u, 1u})
        for (const float height : {0.0f, 2.0f}) // in front, behind
            for (const LightItem& item : sample(lighting, light, {0.1f, height, 0}, 100, 3))
                EXPECT_EQ(item.radiance.y, height < 1 || light == 1 ? 5.0f : 0.0f);
}

// The texture's left half emits, in the triangle's own texture coordinates: u = x.
Lighting textured(AlphaMode alpha_mode, std::uint32_t triangles) {
    Lighting lighting;
    lighting.triangles = {triangle({0, 1, 0}, {1, 1, 0}, {0, 1, 1}),
                          triangle({0, 3, 0}, {1, 3, 0}, {0, 3, 1}, 7)};
    lighting.triangles[0].textured = true;
    lighting.triangles[0].triangle = 1;
    lighting.triangles[1].triangle = 0xfffffff0u; // must not be looked up
    lighting.surfaces.resize(2);
    lighting.surfaces[1].uv0[1] = glm::vec2(1, 0);
    lighting.surfaces[1].uv0[2] = glm::vec2(0, 1);
    TextureImage image;
    image.width = 2;
    image.height = 1;
    image.rgba = {255, 255, 255, 255, 0, 0, 0, 0};
    lighting.scene.images.push_back(image);
    Texture texture;
    texture.wrap_u = texture.wrap_v = Wrap::clamp;
    texture.filter = TextureFilter::nearest;
    lighting.scene.textures.push_back(texture);
    Material material;
    material.emission = glm::vec3(3, 2, 1);
    material.alpha_mode = alpha_mode;
    (alpha_mode == AlphaMode::opaque ? material.emission_texture : material.base_color_texture).texture = 0;
    lighting.scene.materials.push_back(material);
    lighting.features = triangles | (alpha_mode != AlphaMode::opaque ? FEATURE_ALPHA : 0u);
    return lighting;
}

TEST_P(TriangleEmission, LooksTexturesAndAlphaUpAtTheSampledPoint) {
    for (const AlphaMode mode : {AlphaMode::opaque, AlphaMode::mask, AlphaMode::blend}) {
        const glm::vec3 point(0.2f, 0, 0.1f);
        int lit = 0;
        for (const LightItem& item : sample(textured(mode, GetParam()), 0, point, 1000, 3)) {
            const float x = point.x + item.direction.x * item.distance;
            if (std::abs(x - 0.5f) < 1e-4f) continue;
            const glm::vec3 expected = x < 0.5f ? glm::vec3(3, 2, 1) : glm::vec3(0);
            for (int c = 0; c < 3; ++c) EXPECT_NEAR(item.radiance[c], expected[c], 1e-5) << x;
            lit += x < 0.5f ? 1 : 0;
        }
        EXPECT_NEAR(lit, 750, 100);
        for (const LightItem& item : sample(textured(mode, GetParam()), 1, point, 100, 3))
            EXPECT_EQ(item.radiance, glm::vec3(7));
    }
}

} // namespace
} // namespace ajar::test
