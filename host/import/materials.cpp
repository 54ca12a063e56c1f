#include "import/materials.hpp"

#include "import/extensions/table.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace ajar::gltf {

namespace {

void read_metallic_roughness(const JsonObject& object, Textures& textures, Material& material) {
    material.base_color = object.vector<4>("baseColorFactor", glm::vec4(1));
    material.base_color_texture = textures.use(object.object("baseColorTexture"));
    material.metallic = object.number("metallicFactor", 1);
    material.roughness = object.number("roughnessFactor", 1);
    material.metallic_roughness_texture = textures.use(object.object("metallicRoughnessTexture"));
}

void read_alpha(const JsonObject& object, Material& material) {
    const std::string mode = object.text("alphaMode", "OPAQUE");
    if (mode == "MASK")
        material.alpha_mode = AlphaMode::mask;
    else if (mode == "BLEND")
        material.alpha_mode = AlphaMode::blend;
    else if (mode != "OPAQUE")
        object.fail("alphaMode", fmt::format("'{}' is none of OPAQUE, MASK, BLEND", mode));
    material.alpha_cutoff = object.number("alphaCutoff", 0.5f);
}

// Factors outside their range are what some exporters write; the nearest value in range is what they mean.
void clamp_factors(Material& material) {
    material.base_color = glm::clamp(material.base_color, 0.0f, 1.0f);
    material.metallic = std::clamp(material.metallic, 0.0f, 1.0f);
    material.roughness = std::clamp(material.roughness, 0.0f, 1.0f);
    material.occlusion_strength = std::clamp(material.occlusion_strength, 0.0f, 1.0f);
    material.emission = glm::max(material.emission, glm::vec3(0));
}

Material read_material(const JsonObject& object, Textures& textures, Document& document) {
    Material material;
    material.name = object.text("name");
    if (const auto pbr = object.object("pbrMetallicRoughness"))
        read_metallic_roughness(*pbr, textures, material);
    if (const auto info = object.object("normalTexture")) {
        material.normal_scale = info->number("scale", 1);
        material.normal_texture = textures.use(info);
    }
    if (const auto info = object.object("occlusionTexture")) {
        material.occlusion_strength = info->number("strength", 1);
        material.occlusion_texture = textures.use(info);
    }
    material.emission = object.vector<3>("emissiveFactor", glm::vec3(0));
    material.emission_texture = textures.use(object.object("emissiveTexture"));
    read_alpha(object, material);
    material.double_sided = object.flag("doubleSided", false);
    for (const Extension& row : extension_table())
        if (row.read_material)
            if (const auto extension = object.extension(row.name))
                row.read_material({object, *extension, textures, document}, material);
    clamp_factors(material);
    return material;
}

// For a material that no triangle of the scene has: its place is kept, so that indices are the file's.
Material placeholder(const JsonObject& object) {
    Material material;
    material.name = object.text("name");
    return material;
}

} // namespace

void read_materials(Document& document, Textures& textures, const std::vector<bool>& is_used, Scene& scene) {
    for (const JsonObject& object : document.root().objects("materials")) {
        const bool used = is_used[scene.materials.size()];
        scene.materials.push_back(used ? read_material(object, textures, document) : placeholder(object));
    }
}

} // namespace ajar::gltf
