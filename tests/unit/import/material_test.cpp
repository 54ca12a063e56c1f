// Materials, textures, samplers, images and their extensions.
#include "base/file.hpp"
#include "support/temporary_folder.hpp"
#include "unit/import/gltf_builder.hpp"

#include <gtest/gtest.h>

namespace ajar::test {
namespace {

nlohmann::json parse(const char* text) { return nlohmann::json::parse(text); }

// A triangle with that material and one texture of one red texel.
GltfBuilder with_texture(const char* material) {
    GltfBuilder b = textured_triangle(parse(material));
    b.push("images", {{"bufferView", b.view(one_texel(200, 10, 20, 30))}, {"mimeType", "image/png"}});
    b.push("textures", {{"source", 0}});
    return b;
}

constexpr const char* COLOR_MAP = R"({"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}})";

TEST(GltfMaterial, ReadsFactors) {
    const Material m = import(textured_triangle(parse(R"({"name": "m",
        "pbrMetallicRoughness": {"baseColorFactor": [0.1, 0.2, 0.3, 0.4], "metallicFactor": 0.5,
                                 "roughnessFactor": 0.6},
        "emissiveFactor": [0.7, 0.8, 0.9], "alphaMode": "MASK", "alphaCutoff": 0.25, "doubleSided": true})")))
                           .scene.materials.at(0);
    EXPECT_EQ(m.name, "m");
    EXPECT_EQ(m.base_color, glm::vec4(0.1f, 0.2f, 0.3f, 0.4f));
    EXPECT_EQ(m.metallic, 0.5f);
    EXPECT_EQ(m.roughness, 0.6f);
    EXPECT_EQ(m.emission, glm::vec3(0.7f, 0.8f, 0.9f));
    EXPECT_EQ(m.alpha_mode, AlphaMode::mask);
    EXPECT_EQ(m.alpha_cutoff, 0.25f);
    EXPECT_TRUE(m.double_sided);
}

TEST(GltfMaterial, HasTheDefaultsOfTheSpecification) {
    const Material m = import(textured_triangle(nlohmann::json::object())).scene.materials.at(0);
    EXPECT_EQ(m.base_color, glm::vec4(1));
    EXPECT_EQ(m.metallic, 1.0f);
    EXPECT_EQ(m.roughness, 1.0f);
    EXPECT_EQ(m.emission, glm::vec3(0));
    EXPECT_EQ(m.alpha_mode, AlphaMode::opaque);
    EXPECT_EQ(m.alpha_cutoff, 0.5f);
    EXPECT_FALSE(m.double_sided);
    EXPECT_EQ(m.ior, 1.5f);
}

TEST(GltfMaterial, ReadsAllFiveTextureSlots) {
    const GltfBuilder b = with_texture(R"({"pbrMetallicRoughness": {
        "baseColorTexture": {"index": 0}, "metallicRoughnessTexture": {"index": 0, "texCoord": 1}},
        "normalTexture": {"index": 0, "scale": 0.5}, "occlusionTexture": {"index": 0, "strength": 0.25},
        "emissiveTexture": {"index": 0}})");
    const Scene scene = import(b).scene;
    const Material& m = scene.materials.at(0);
    for (const TextureUse* use : {&m.base_color_texture, &m.metallic_roughness_texture, &m.normal_texture,
                                  &m.occlusion_texture, &m.emission_texture})
        EXPECT_EQ(use->texture, 0u);
    EXPECT_EQ(m.metallic_roughness_texture.uv_set, 1u);
    EXPECT_EQ(m.normal_scale, 0.5f);
    EXPECT_EQ(m.occlusion_strength, 0.25f);
    ASSERT_EQ(scene.images.size(), 1u);
    EXPECT_EQ(scene.images[0].rgba, (std::vector<std::uint8_t>{200, 10, 20, 30}));
}

TEST(GltfMaterial, RejectsUnknownAlphaModesAndMissingTextures) {
    EXPECT_NE(import_error(textured_triangle({{"alphaMode", "DITHER"}})).find("alphaMode"),
              std::string::npos);
    EXPECT_NE(import_error(textured_triangle(parse(COLOR_MAP))).find("texture 0 does not exist"),
              std::string::npos);
    EXPECT_NE(import_error(textured_triangle({{"emissiveFactor", {1, 2}}})).find("must have 3 numbers"),
              std::string::npos);
    EXPECT_NE(import_error(textured_triangle({{"alphaCutoff", 1e300}})).find("too large"), std::string::npos);
}

TEST(GltfMaterial, ReadsTexturesOfShownMaterialsOnly) {
    GltfBuilder b = with_texture("{}");
    b.push("materials", parse(COLOR_MAP)); // of no triangle
    b.json["images"][0] = {{"uri", "gone.png"}};
    const Scene scene = import(b).scene;
    EXPECT_EQ(scene.materials.size(), 2u);
    EXPECT_TRUE(scene.images.empty());
    EXPECT_FALSE(scene.materials[1].base_color_texture.used());
}

TEST(GltfTexture, ReadsSamplers) {
    GltfBuilder b = with_texture(COLOR_MAP);
    b.push("samplers", {{"wrapS", 33071}, {"wrapT", 33648}, {"magFilter", 9728}});
    EXPECT_EQ(import(b).scene.textures.at(0).wrap_u, Wrap::repeat);
    b.json["textures"][0]["sampler"] = 0;
    const Texture texture = import(b).scene.textures.at(0);
    EXPECT_EQ(texture.wrap_u, Wrap::clamp);
    EXPECT_EQ(texture.wrap_v, Wrap::mirror);
    EXPECT_EQ(texture.filter, TextureFilter::nearest);
    b.json["samplers"][0]["wrapS"] = 5;
    EXPECT_NE(import_error(b).find("samplers[0].wrapS"), std::string::npos);
}

TEST(GltfTexture, ReadsImagesFromFilesAndDataUris) {
    const TemporaryFolder folder;
    GltfBuilder b = with_texture(COLOR_MAP);
    write_file(folder / "\xc3\xa9t\xc3\xa9 1.png", one_texel(1, 2, 3));
    b.json["images"] = {{{"uri", "%C3%A9t%C3%A9%201.png"}},
                        {{"uri", "data:image/png;base64," + base64(one_texel(4, 5, 6))}}};
    EXPECT_EQ(import_text(b.text(), folder.path()).scene.images.at(0).rgba[2], 3);
    b.json["textures"][0]["source"] = 1;
    EXPECT_EQ(import_text(b.text(), folder.path()).scene.images.at(0).rgba[2], 6);
}

TEST(GltfTexture, RejectsDamagedAndMissingImages) {
    GltfBuilder b = with_texture(COLOR_MAP);
    b.json["images"][0] = {{"uri", "data:image/png;base64,AAAA"}};
    EXPECT_NE(import_error(b).find("images[0]"), std::string::npos);
    b.json["images"][0] = nlohmann::json::object();
    EXPECT_NE(import_error(b).find("images[0]"), std::string::npos);
    b.json["images"][0] = {{"bufferView", 99}};
    EXPECT_NE(import_error(b).find("buffer view 99 does not exist"), std::string::npos);
}

TEST(GltfTexture, IsIgnoredWithoutAnImage) {
    GltfBuilder b = with_texture(COLOR_MAP);
    b.json["textures"][0] = nlohmann::json::object();
    const ImportResult result = import(b);
    EXPECT_FALSE(result.scene.materials[0].base_color_texture.used());
    EXPECT_EQ(result.info.warnings.size(), 1u);
}

TEST(GltfTexture, IsIgnoredOnAThirdSetOfCoordinates) {
    const ImportResult result = import(
        with_texture(R"({"pbrMetallicRoughness": {"baseColorTexture": {"index": 0, "texCoord": 2}}})"));
    EXPECT_FALSE(result.scene.materials[0].base_color_texture.used());
    EXPECT_EQ(result.info.warnings.size(), 1u);
}

TEST(GltfTexture, ReadsWebP) {
    // The smallest lossless WebP: one black, opaque texel (WebP Lossless Bitstream Specification).
    GltfBuilder b = with_texture(COLOR_MAP);
    b.push("images", {{"uri", "data:image/webp;base64,UklGRhoAAABXRUJQVlA4TA0AAAAvAAAAEAcQERGIiP4HAA=="}});
    b.json["textures"][0]["extensions"]["EXT_texture_webp"]["source"] = 1;
    b.json["extensionsRequired"] = {"EXT_texture_webp"};
    const Scene scene = import(b).scene;
    ASSERT_EQ(scene.images.size(), 1u);
    EXPECT_EQ(scene.images[0].width, 1u);
    EXPECT_NE(scene.images[0].rgba[0], 200) << "the PNG beside it was read";
}

TEST(GltfTexture, IsTransformedByScaleThenRotationThenOffset) { // KHR_texture_transform
    const Material m =
        import(with_texture(R"({"pbrMetallicRoughness": {"baseColorTexture": {"index": 0, "extensions":
        {"KHR_texture_transform": {"offset": [0.5, 0.25], "rotation": 1.5707963, "scale": [2, 3],
                                   "texCoord": 1}}}}})"))
            .scene.materials[0];
    const TextureUse& use = m.base_color_texture;
    EXPECT_EQ(use.uv_set, 1u);
    // (0.1, 0.2) -> scaled (0.2, 0.6) -> a quarter turn that takes +u to -v and +v to +u: (0.6, -0.2) ->
    // (1.1, 0.05).
    const glm::vec3 uv(0.1f, 0.2f, 1);
    EXPECT_NEAR(glm::dot(use.uv_row_u, uv), 1.1f, 1e-6f);
    EXPECT_NEAR(glm::dot(use.uv_row_v, uv), 0.05f, 1e-6f);
}

Material with_extension(const char* name, const char* value) {
    nlohmann::json material = parse(R"({"emissiveFactor": [1, 0.5, 0], "extensions": {}})");
    material["extensions"][name] = parse(value);
    return import(textured_triangle(material)).scene.materials.at(0);
}

TEST(GltfMaterialExtension, MultipliesEmission) {
    EXPECT_EQ(with_extension("KHR_materials_emissive_strength", R"({"emissiveStrength": 5})").emission,
              glm::vec3(5, 2.5f, 0));
    EXPECT_EQ(with_extension("KHR_materials_emissive_strength", "{}").emission, glm::vec3(1, 0.5f, 0));
}

TEST(GltfMaterialExtension, ReadsUnlitIorAndSpecular) {
    EXPECT_TRUE(with_extension("KHR_materials_unlit", "{}").unlit);
    EXPECT_EQ(with_extension("KHR_materials_ior", R"({"ior": 1.33})").ior, 1.33f);
    EXPECT_EQ(with_extension("KHR_materials_ior", R"({"ior": 0})").ior, 0.0f);
    const Material m = with_extension("KHR_materials_specular",
                                      R"({"specularFactor": 0.5, "specularColorFactor": [2, 0.5, 1]})");
    EXPECT_EQ(m.specular, 0.5f);
    EXPECT_EQ(m.specular_color, glm::vec3(2, 0.5f, 1));
}

TEST(GltfMaterialExtension, RejectsImpossibleValues) {
    EXPECT_NE(import_error(textured_triangle(parse(R"({"extensions": {"KHR_materials_ior": {"ior": 0.5}}})")))
                  .find("ior"),
              std::string::npos);
    EXPECT_NE(import_error(textured_triangle(parse(R"({"extensions": {"KHR_materials_unlit": []}})")))
                  .find("object"),
              std::string::npos);
}

TEST(GltfMaterialExtension, ApproximatesSpecularGlossiness) {
    GltfBuilder b = textured_triangle(parse(R"({"extensions": {"KHR_materials_pbrSpecularGlossiness":
        {"diffuseFactor": [0.1, 0.2, 0.3, 1], "glossinessFactor": 0.25}}})"));
    b.json["extensionsUsed"] = {"KHR_materials_pbrSpecularGlossiness"};
    const ImportResult result = import(b);
    const Material& m = result.scene.materials[0];
    EXPECT_EQ(m.base_color, glm::vec4(0.1f, 0.2f, 0.3f, 1));
    EXPECT_EQ(m.metallic, 0.0f);
    EXPECT_EQ(m.roughness, 0.75f);
    EXPECT_EQ(result.info.warnings.size(), 1u);
    EXPECT_EQ(result.info.extensions.at(0).support, ExtensionSupport::approximated);
}

} // namespace
} // namespace ajar::test
