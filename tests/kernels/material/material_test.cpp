// Materials: factors times textures (glTF 2.0, 3.9), alpha modes, normal maps; with and without the features
// compiled in.
#include "material_functions.hpp"

#include <cmath>

namespace ajar::test {
namespace {

struct Point {
    glm::vec4 base_color;
    glm::vec3 emission;
    float metallic;
    glm::vec3 normal;
    float alpha_ggx;
    glm::vec3 f0;
    float f90;
    glm::vec3 emission_alone; // material_emission
    float alpha;              // material_alpha
};

shared::MaterialRecord plain() {
    shared::MaterialRecord m{};
    m.base_color = {0.8f, 0.6f, 0.4f, 0.5f};
    m.emission = {2, 3, 4};
    m.metallic = 0.75f;
    m.roughness = 0.6f;
    m.normal_scale = 1;
    m.alpha_cutoff = 0.5f;
    m.dielectric_f0 = {0.04f, 0.03f, 0.02f};
    m.dielectric_f90 = 0.9f;
    m.base_color_texture = m.metallic_roughness_texture = m.normal_texture = m.emission_texture =
        shared::NO_TEXTURE;
    return m;
}

TestTexture one_texel(const Texel& texel, std::uint32_t flags = 0) { return {1, 1, {texel}, flags}; }

class Material : public MaterialFunctions {
  protected:
    static Point point(const shared::MaterialRecord& material, const std::vector<TestTexture>& textures = {},
                       const glm::vec4& vertex_color = glm::vec4(1), std::uint32_t features = ALL_FEATURES) {
        TestMaterials scene;
        scene.materials = {plain(), material};
        scene.textures = textures;
        const auto w =
            run(shared::MATERIAL_POINT, scene, 1, {glm::vec4(0.3f, 0.6f, 0, 0)}, vertex_color, features);
        return {w[0], w[1], w[1].w, w[2], w[2].w, w[3], w[3].w, w[4], w[4].w};
    }
};

TEST_F(Material, WithoutTexturesIsItsFactors) {
    for (const std::uint32_t features : {ALL_FEATURES, std::uint32_t(shared::FEATURE_SPECULAR)}) {
        const Point p = point(plain(), {}, glm::vec4(0.5f, 1, 1, 1), features);
        EXPECT_EQ(p.base_color, glm::vec4(0.4f, 0.6f, 0.4f, 1));
        EXPECT_EQ(p.emission, glm::vec3(2, 3, 4));
        EXPECT_EQ(p.emission_alone, glm::vec3(2, 3, 4));
        EXPECT_EQ(p.metallic, 0.75f);
        EXPECT_FLOAT_EQ(p.alpha_ggx, 0.36f);
        EXPECT_EQ(p.normal, glm::vec3(0, 0, 1));
        EXPECT_EQ(p.f0, glm::vec3(0.04f, 0.03f, 0.02f));
        EXPECT_EQ(p.f90, 0.9f);
        EXPECT_EQ(p.alpha, 1); // opaque
    }
}

TEST_F(Material, WithoutTheSpecularFeatureIsLambert) {
    shared::MaterialRecord m = plain();
    m.metallic = 0;
    const Point p = point(m, {}, glm::vec4(1), 0);
    EXPECT_EQ(p.metallic, 0);
    EXPECT_EQ(p.f0, glm::vec3(0));
    EXPECT_EQ(p.f90, 0);
}

TEST_F(Material, MultipliesFactorsByTextures) {
    shared::MaterialRecord m = plain();
    m.base_color_texture = 0;
    m.metallic_roughness_texture = 1;
    m.emission_texture = 2;
    const Point p =
        point(m, {one_texel({255, 51, 102, 255}, shared::TEXTURE_SRGB), one_texel({7, 102, 51, 9}),
                  one_texel({51, 255, 0, 255}, shared::TEXTURE_SRGB)});
    const float fifth = 0.0331047666f; // 0.2 and 0.4 decoded
    const float two_fifths = 0.132868322f;
    EXPECT_LT(glm::distance(p.base_color, glm::vec4(0.8f, 0.6f * fifth, 0.4f * two_fifths, 1)), 1e-6f);
    EXPECT_NEAR(p.metallic, 0.75f * 0.2f, 1e-6f);   // B
    EXPECT_NEAR(p.alpha_ggx, 0.36f * 0.16f, 1e-6f); // G, then squared
    EXPECT_LT(glm::distance(p.emission, glm::vec3(2 * fifth, 3, 0)), 1e-5f);
    EXPECT_EQ(p.emission, p.emission_alone);
}

TEST_F(Material, DecidesAlphaByItsMode) {
    struct Case {
        std::uint32_t flags;
        float factor;
        std::uint8_t texel;
        float vertex;
        float expected;
    };
    const Case cases[] = {{0, 0.1f, 128, 0.5f, 1},
                          {shared::MATERIAL_MASK, 1, 127, 1, 0}, // 127 / 255 < 1 / 2
                          {shared::MATERIAL_MASK, 1, 128, 1, 1},
                          {shared::MATERIAL_MASK, 0.5f, 255, 1, 1}, // exactly the cutoff: there
                          {shared::MATERIAL_MASK, 0.9f, 255, 0.5f, 0},
                          {shared::MATERIAL_BLEND, 0.5f, 102, 0.5f, 0.1f},
                          {shared::MATERIAL_BLEND, 2, 255, 1, 1},
                          {shared::MATERIAL_BLEND, 1, 0, 1, 0}};
    for (const Case& c : cases) {
        SCOPED_TRACE(testing::Message() << c.flags << " " << c.factor << " " << int(c.texel));
        shared::MaterialRecord m = plain();
        m.flags = c.flags;
        m.base_color.a = c.factor;
        m.base_color_texture = 0;
        const Point p =
            point(m, {one_texel({9, 9, 9, c.texel}, shared::TEXTURE_SRGB)}, glm::vec4(1, 1, 1, c.vertex));
        EXPECT_NEAR(p.alpha, c.expected, 1e-6f);
        EXPECT_EQ(p.base_color.a, p.alpha);
    }
}

TEST_F(Material, TiltsItsNormalByTheMapAndItsScale) {
    shared::MaterialRecord m = plain();
    m.normal_texture = 0;
    const Texel texel(204, 51, 230, 255); // 0.6, -0.6, 0.80392
    for (const float scale : {1.0f, 0.5f, 0.0f, -1.0f, 3.0f}) {
        m.normal_scale = scale;
        const glm::dvec3 expected = glm::normalize(glm::dvec3(0.6 * scale, -0.6 * scale, 230 / 127.5 - 1));
        EXPECT_LT(glm::distance(glm::dvec3(point(m, {one_texel(texel)}).normal), expected), 1e-6) << scale;
    }
    // Not compiled in: no map.
    EXPECT_EQ(point(m, {one_texel(texel)}, glm::vec4(1), ALL_FEATURES & ~shared::FEATURE_NORMAL_MAPS).normal,
              glm::vec3(0, 0, 1));
}

TEST_F(Material, SurvivesANormalMapThatCancelsOut) {
    // Texels 64 and 191 average to 127.5 exactly: a zero vector in the middle.
    shared::MaterialRecord m = plain();
    m.normal_texture = 0;
    TestMaterials scene;
    scene.materials = {m};
    scene.textures = {{2, 1, {Texel(64, 64, 64, 255), Texel(191, 191, 191, 255)}, shared::WRAP_CLAMP}};
    std::vector<glm::vec4> uv;
    for (int k = -500; k <= 500; ++k) uv.emplace_back(0.5f + float(k) * 1e-7f, 0.5f, 0, 0);
    const auto words = run(shared::MATERIAL_POINT, scene, 0, uv);
    for (std::size_t k = 2; k < words.size(); k += shared::MATERIAL_WORDS)
        ASSERT_NEAR(glm::length(glm::vec3(words[k])), 1, 1e-5);
}

TEST_F(Material, KeepsItsParametersInRange) {
    shared::MaterialRecord m = plain();
    m.base_color = {4, -1, 0.5f, 7};
    m.metallic = 3;
    m.roughness = 2;
    const Point p = point(m);
    EXPECT_EQ(p.base_color, glm::vec4(1, 0, 0.5f, 1));
    EXPECT_EQ(p.metallic, 1);
    EXPECT_EQ(p.alpha_ggx, 1);
}

} // namespace
} // namespace ajar::test
