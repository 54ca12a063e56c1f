#include "export/materials.hpp"

#include "base/error.hpp"
#include "image/write.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace ajar::gltf_out {

namespace {

constexpr float TRANSFORM_ROUNDING = 1e-5f; // relative, of rows made of a sine, a cosine and a scale

int wrap_code(Wrap wrap) { return wrap == Wrap::clamp ? 33071 : wrap == Wrap::mirror ? 33648 : 10497; }

// The rows are translation * rotation * scale as KHR_texture_transform has it (host/import/README.md).
Json texture_transform(const TextureUse& use, const Material& material) {
    const glm::vec2 axis_u(use.uv_row_u.x, use.uv_row_v.x), axis_v(use.uv_row_u.y, use.uv_row_v.y);
    const float angle =
        glm::length(axis_u) > 0 ? std::atan2(-axis_u.y, axis_u.x) : std::atan2(axis_v.x, axis_v.y);
    const float c = std::cos(angle), s = std::sin(angle);
    const glm::vec2 scale(c * axis_u.x - s * axis_u.y, s * axis_v.x + c * axis_v.y);
    const float flaw = std::max(std::abs(s * axis_u.x + c * axis_u.y), std::abs(c * axis_v.x - s * axis_v.y));
    if (!(flaw <= TRANSFORM_ROUNDING * std::max(glm::length(axis_u), glm::length(axis_v))))
        throw Error(fmt::format("material '{}': its texture coordinates are sheared, which glTF cannot say",
                                material.name));
    Json transform;
    const glm::vec2 offset(use.uv_row_u.z, use.uv_row_v.z);
    if (offset != glm::vec2(0)) transform["offset"] = numbers(offset);
    if (angle != 0) transform["rotation"] = angle;
    if (scale != glm::vec2(1)) transform["scale"] = numbers(scale);
    return transform;
}

class MaterialWriter {
  public:
    MaterialWriter(const Material& material, Document& document) : m_(material), document_(document) {}

    Json write() {
        set_name(json_, m_.name);
        write_metallic_roughness();
        if (m_.normal_texture.used()) {
            json_["normalTexture"] = use(m_.normal_texture);
            if (m_.normal_scale != 1) json_["normalTexture"]["scale"] = m_.normal_scale;
        }
        if (m_.occlusion_texture.used()) {
            json_["occlusionTexture"] = use(m_.occlusion_texture);
            if (m_.occlusion_strength != 1) json_["occlusionTexture"]["strength"] = m_.occlusion_strength;
        }
        if (m_.emission_texture.used()) json_["emissiveTexture"] = use(m_.emission_texture);
        if (m_.emission != glm::vec3(0)) write_emission();
        write_alpha();
        if (m_.double_sided) json_["doubleSided"] = true;
        if (m_.unlit) extension("KHR_materials_unlit");
        if (m_.ior != 1.5f) extension("KHR_materials_ior")["ior"] = m_.ior;
        if (m_.specular != 1) extension("KHR_materials_specular")["specularFactor"] = m_.specular;
        if (m_.specular_color != glm::vec3(1))
            extension("KHR_materials_specular")["specularColorFactor"] = numbers(m_.specular_color);
        return json_.is_null() ? Json::object() : json_;
    }

  private:
    Json& extension(const char* name) {
        document_.uses(name);
        Json& place = json_["extensions"][name];
        if (place.is_null()) place = Json::object();
        return place;
    }

    Json use(const TextureUse& use) {
        Json info{{"index", use.texture}};
        if (use.uv_set != 0) info["texCoord"] = use.uv_set;
        Json transform = texture_transform(use, m_);
        if (transform.is_null()) return info;
        document_.uses("KHR_texture_transform");
        info["extensions"]["KHR_texture_transform"] = std::move(transform);
        return info;
    }

    void write_metallic_roughness() {
        Json pbr;
        if (m_.base_color != glm::vec4(1)) pbr["baseColorFactor"] = numbers(m_.base_color);
        if (m_.base_color_texture.used()) pbr["baseColorTexture"] = use(m_.base_color_texture);
        if (m_.metallic != 1) pbr["metallicFactor"] = m_.metallic;
        if (m_.roughness != 1) pbr["roughnessFactor"] = m_.roughness;
        if (m_.metallic_roughness_texture.used())
            pbr["metallicRoughnessTexture"] = use(m_.metallic_roughness_texture);
        if (!pbr.is_null()) json_["pbrMetallicRoughness"] = std::move(pbr);
    }

    void write_emission() {
        const ScaledColor scaled = scaled_color(m_.emission);
        json_["emissiveFactor"] = numbers(scaled.color);
        if (scaled.factor != 1)
            extension("KHR_materials_emissive_strength")["emissiveStrength"] = scaled.factor;
    }

    void write_alpha() {
        if (m_.alpha_mode == AlphaMode::opaque) return;
        json_["alphaMode"] = m_.alpha_mode == AlphaMode::mask ? "MASK" : "BLEND";
        if (m_.alpha_mode == AlphaMode::mask && m_.alpha_cutoff != 0.5f)
            json_["alphaCutoff"] = m_.alpha_cutoff;
    }

    const Material& m_;
    Document& document_;
    Json json_;
};

// Alpha is stored where there is any: a PNG without it reads as opaque.
std::vector<std::byte> as_png(const TextureImage& image) {
    bool opaque = true;
    for (std::size_t i = 3; i < image.rgba.size(); i += 4) opaque = opaque && image.rgba[i] == 255;
    if (!opaque) return encode_png(image.width, image.height, 4, image.rgba);
    std::vector<std::uint8_t> rgb;
    rgb.reserve(image.rgba.size() / 4 * 3);
    for (std::size_t i = 0; i < image.rgba.size(); i += 4)
        rgb.insert(rgb.end(), image.rgba.begin() + static_cast<std::ptrdiff_t>(i),
                   image.rgba.begin() + static_cast<std::ptrdiff_t>(i + 3));
    return encode_png(image.width, image.height, 3, rgb);
}

std::uint32_t sampler_of(const Texture& texture, Document& document) {
    constexpr int NEAREST = 9728, LINEAR = 9729, LINEAR_MIPMAP_LINEAR = 9987, NEAREST_MIPMAP_LINEAR = 9986;
    const bool nearest = texture.filter == TextureFilter::nearest;
    const Json sampler{{"magFilter", nearest ? NEAREST : LINEAR},
                       {"minFilter", nearest ? NEAREST_MIPMAP_LINEAR : LINEAR_MIPMAP_LINEAR},
                       {"wrapS", wrap_code(texture.wrap_u)},
                       {"wrapT", wrap_code(texture.wrap_v)}};
    const Json& samplers = document.root()["samplers"];
    const auto known = std::find(samplers.begin(), samplers.end(), sampler);
    if (known != samplers.end()) return static_cast<std::uint32_t>(known - samplers.begin());
    return document.push("samplers", sampler);
}

} // namespace

ScaledColor scaled_color(const glm::vec3& color) {
    int exponent = 0;
    const float most = std::max({color.x, color.y, color.z, 0.0f});
    if (most <= 1) return {color, 1};
    const float fraction = std::frexp(most, &exponent); // in [1/2, 1)
    const float factor = std::ldexp(1.0f, fraction == 0.5f ? exponent - 1 : exponent);
    return {color / factor, factor};
}

void add_materials(const Scene& scene, Document& document) {
    for (const Material& material : scene.materials)
        document.push("materials", MaterialWriter(material, document).write());
}

void add_textures(const Scene& scene, Document& document) {
    for (const TextureImage& image : scene.images) {
        Json json;
        set_name(json, image.name);
        json["mimeType"] = "image/png";
        json["bufferView"] = document.view(as_png(image), Target::none);
        document.push("images", std::move(json));
    }
    for (const Texture& texture : scene.textures) {
        Json json;
        set_name(json, texture.name);
        json["sampler"] = sampler_of(texture, document);
        json["source"] = texture.image;
        document.push("textures", std::move(json));
    }
}

} // namespace ajar::gltf_out
