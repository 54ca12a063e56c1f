// Mean emission of textured triangles against sums over their texels.
#include "render/emission_means.hpp"

#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <random>

namespace ajar {
namespace {

using Uv = std::array<glm::vec2, 3>;

Scene emissive_scene(std::uint32_t width, std::uint32_t height,
                     const std::function<std::uint8_t(std::uint32_t, std::uint32_t)>& value,
                     Wrap wrap = Wrap::repeat, TextureFilter filter = TextureFilter::linear) {
    Scene scene;
    TextureImage image;
    image.width = width;
    image.height = height;
    for (std::uint32_t y = 0; y < height; ++y)
        for (std::uint32_t x = 0; x < width; ++x)
            image.rgba.insert(image.rgba.end(), {value(x, y), 0, 0, 255});
    scene.images.push_back(std::move(image));
    Texture texture;
    texture.wrap_u = texture.wrap_v = wrap;
    texture.filter = filter;
    scene.textures.push_back(texture);
    Material material;
    material.emission = glm::vec3(2, 3, 4);
    material.emission_texture.texture = 0;
    scene.materials.push_back(material);
    return scene;
}

TEST(EmissionMeans, OfAnUntexturedMaterialIsItsEmission) {
    Scene scene;
    scene.materials.resize(1);
    scene.materials[0].emission = glm::vec3(1, 2, 3);
    EXPECT_EQ(EmissionMeans(scene).mean(0, Uv{}), glm::vec3(1, 2, 3));
}

TEST(EmissionMeans, AveragesLinearValuesOverTheTriangle) {
    // Left half white: a triangle over the whole square has three quarters of its area there, or one.
    const Scene scene = emissive_scene(64, 64, [](auto x, auto) { return x < 32 ? 255 : 0; });
    const glm::vec3 three =
        EmissionMeans(scene).mean(0, Uv{glm::vec2(0, 0), glm::vec2(1, 0), glm::vec2(0, 1)});
    EXPECT_NEAR(three.x, 2 * 0.75, 2 * 0.05);
    EXPECT_EQ(three.y, 0.0f);
    const glm::vec3 one = EmissionMeans(scene).mean(0, Uv{glm::vec2(1, 0), glm::vec2(1, 1), glm::vec2(0, 1)});
    EXPECT_NEAR(one.x, 2 * 0.25, 2 * 0.05);
    const Scene grey = emissive_scene(4, 4, [](auto, auto) { return 188; });
    EXPECT_NEAR(EmissionMeans(grey).mean(0, Uv{glm::vec2(0, 0), glm::vec2(1, 0), glm::vec2(0, 1)}).x,
                2 * 0.5028865f, 1e-4);
}

TEST(EmissionMeans, AppliesTheTextureTransform) {
    Scene scene = emissive_scene(64, 64, [](auto x, auto y) { return x < 32 && y >= 32 ? 255 : 0; });
    scene.materials[0].emission_texture.uv_row_u = glm::vec3(0.25f, 0, 0.05f);
    scene.materials[0].emission_texture.uv_row_v = glm::vec3(0, 0.25f, 0.6f);
    EXPECT_FLOAT_EQ(EmissionMeans(scene).mean(0, Uv{glm::vec2(0, 0), glm::vec2(1, 0), glm::vec2(0, 1)}).x,
                    2.0f);
}

constexpr glm::vec2 SIZE(300, 200);

glm::vec2 wrapped(glm::vec2 p, Wrap wrap) {
    if (wrap == Wrap::clamp) return glm::clamp(p, 0.0f, 1.0f);
    if (wrap == Wrap::mirror) return 1.0f - glm::abs(glm::mod(p, 2.0f) - 1.0f);
    return glm::fract(p);
}

// Whether a bilinear lookup of any of many points of the triangle reads the texel.
bool shows_texel(const Uv& uv, glm::vec2 texel, Wrap wrap, std::mt19937& random) {
    std::uniform_real_distribution<float> uniform(0, 1);
    for (int k = 0; k < 5000; ++k) {
        float a = uniform(random);
        float b = uniform(random);
        if (a + b > 1) a = 1 - a, b = 1 - b;
        const glm::vec2 p = wrapped(uv[0] + a * (uv[1] - uv[0]) + b * (uv[2] - uv[0]), wrap);
        glm::vec2 distance = glm::abs(p * SIZE - texel - 0.5f);
        if (wrap == Wrap::repeat) distance = glm::min(distance, SIZE - distance);
        // A hair inside: what is lit by less than a thousandth does not matter, and floats differ.
        if (distance.x < 0.999f && distance.y < 0.999f) return true;
    }
    return false;
}

// One lit texel in a large image: every triangle that can show it has a mean that is not negligible.
TEST(EmissionMeans, NeverMissesATexelThatTheTriangleShows) {
    std::mt19937 random(3);
    std::uniform_real_distribution<float> uniform(0, 1);
    for (const Wrap wrap : {Wrap::repeat, Wrap::mirror, Wrap::clamp})
        for (const glm::vec2 lit : {glm::vec2(123, 45), glm::vec2(0, 199), glm::vec2(299, 100)}) {
            const Scene scene = emissive_scene(
                300, 200, [&](auto x, auto y) { return glm::vec2(x, y) == lit ? 255 : 0; }, wrap);
            const EmissionMeans means(scene);
            int shown = 0;
            for (int i = 0; i < 100; ++i) {
                // Around the texel, in some copy of the texture.
                const float size = std::exp(-6 * uniform(random));
                glm::vec2 center = (lit + 0.5f) / SIZE;
                for (int axis = 0; axis < 2; ++axis) {
                    const auto copy = static_cast<float>(static_cast<int>(random() % 5) - 2);
                    if (wrap == Wrap::repeat) center[axis] += copy;
                    if (wrap == Wrap::mirror)
                        center[axis] =
                            copy + (std::fmod(copy, 2.0f) == 0.0f ? center[axis] : 1 - center[axis]);
                }
                Uv uv;
                for (glm::vec2& p : uv)
                    p = center + size * (2.0f * glm::vec2(uniform(random), uniform(random)) - 1.0f);
                if (!shows_texel(uv, lit, wrap, random)) continue;
                ++shown;
                EXPECT_GE(means.mean(0, uv).x, 2.0f / 64);
            }
            EXPECT_GT(shown, 20) << "the test must test something";
        }
}

TEST(EmissionMeans, IsExactlyZeroWhereNothingIsLit) {
    const Scene scene = emissive_scene(1024, 1024, [](auto x, auto) { return x == 512 ? 255 : 0; });
    const EmissionMeans means(scene);
    EXPECT_EQ(means.mean(0, Uv{glm::vec2(0.1f, 0.1f), glm::vec2(0.4f, 0.1f), glm::vec2(0.1f, 0.9f)}),
              glm::vec3(0));
    // A sliver along the diagonal has a large box, but its outline stays clear of most of it.
    EXPECT_EQ(means.mean(0, Uv{glm::vec2(0.6f, 0), glm::vec2(0.9f, 0), glm::vec2(0.9f, 1)}), glm::vec3(0));
    EXPECT_GT(means.mean(0, Uv{glm::vec2(0.4f, 0.1f), glm::vec2(0.6f, 0.1f), glm::vec2(0.5f, 0.2f)}).x, 0.0f);
}

TEST(EmissionMeans, SurvivesAbsurdTextureCoordinates) {
    const Scene scene = emissive_scene(16, 16, [](auto x, auto y) { return x == y ? 255 : 0; });
    const EmissionMeans means(scene);
    for (const float huge : {1e4f, 1e9f, 1e30f, INFINITY, NAN}) {
        const glm::vec3 mean = means.mean(0, Uv{glm::vec2(-huge, 0), glm::vec2(huge, 1), glm::vec2(0, huge)});
        EXPECT_GE(mean.x, 2.0f / 64) << huge;
        EXPECT_LE(mean.x, 2.0f) << huge;
    }
}

} // namespace
} // namespace ajar
