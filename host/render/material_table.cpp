#include "render/material_table.hpp"

#include "base/error.hpp"
#include "shaders/shared/bvh.glsl.h"
#include "shaders/shared/specialization.glsl.h"

#include <cstring>
#include <fmt/format.h>

namespace ajar {

namespace {

using namespace shared;

class Builder {
  public:
    explicit Builder(const Scene& scene) : scene_(scene), first_texel_(scene.images.size(), NO_INDEX) {}

    MaterialTable build() {
        for (const Material& m : scene_.materials) table_.materials.push_back(record(m));
        return std::move(table_);
    }

  private:
    MaterialRecord record(const Material& m) {
        MaterialRecord r{};
        r.base_color = m.base_color;
        r.emission = m.emission;
        r.flags = flags(m);
        r.metallic = m.metallic;
        r.roughness = m.roughness;
        r.normal_scale = m.normal_scale;
        r.alpha_cutoff = m.alpha_cutoff;
        const float reflectance = (m.ior - 1) / (m.ior + 1);
        r.dielectric_f0 = m.specular * glm::min(reflectance * reflectance * m.specular_color, glm::vec3(1));
        r.dielectric_f90 = m.specular;
        r.base_color_texture = use(m.base_color_texture, true);
        r.metallic_roughness_texture = use(m.metallic_roughness_texture, false);
        r.normal_texture = use(m.normal_texture, false);
        r.emission_texture = use(m.emission_texture, true);
        note_features(m, r);
        return r;
    }

    static std::uint32_t flags(const Material& m) {
        std::uint32_t bits = 0;
        if (m.double_sided) bits |= MATERIAL_DOUBLE_SIDED;
        if (m.unlit) bits |= MATERIAL_UNLIT;
        if (m.alpha_mode == AlphaMode::mask) bits |= MATERIAL_MASK;
        if (m.alpha_mode == AlphaMode::blend) bits |= MATERIAL_BLEND;
        if (!m.unlit && m.emission != glm::vec3(0)) bits |= MATERIAL_EMISSIVE;
        return bits;
    }

    void note_features(const Material& m, const MaterialRecord& r) {
        const bool dielectric_reflects = r.dielectric_f0 != glm::vec3(0) || r.dielectric_f90 != 0;
        const bool reflects = !m.unlit && (m.metallic != 0 || dielectric_reflects);
        if (reflects) table_.features |= FEATURE_SPECULAR;
        // A texture can take roughness down to zero; the lobe's own threshold is below 0.1.
        if (reflects && (m.roughness < 0.1f || m.metallic_roughness_texture.used()))
            table_.features |= FEATURE_DELTA;
        if (m.normal_texture.used()) table_.features |= FEATURE_NORMAL_MAPS;
        if (m.unlit) table_.features |= FEATURE_UNLIT;
        if (m.emission_texture.used() && m.emission != glm::vec3(0))
            table_.features |= FEATURE_EMISSION_TEXTURES;
        if (!table_.textures.empty()) table_.features |= FEATURE_TEXTURES;
    }

    std::uint32_t use(const TextureUse& texture_use, bool srgb) {
        if (!texture_use.used()) return NO_TEXTURE;
        const Texture& texture = scene_.textures[texture_use.texture];
        const TextureImage& image = scene_.images[texture.image];
        TextureRecord r{};
        r.first_texel = upload(texture.image);
        r.width = image.width;
        r.height = image.height;
        r.flags = wrap(texture.wrap_u) | wrap(texture.wrap_v) << TEXTURE_WRAP_V_SHIFT;
        if (texture.filter == TextureFilter::nearest) r.flags |= TEXTURE_NEAREST;
        if (srgb) r.flags |= TEXTURE_SRGB;
        if (texture_use.uv_set == 1) {
            r.flags |= TEXTURE_UV1;
            table_.uses_uv1 = true;
        }
        r.uv_row_u = texture_use.uv_row_u;
        r.uv_row_v = texture_use.uv_row_v;
        table_.textures.push_back(r);
        return static_cast<std::uint32_t>(table_.textures.size() - 1);
    }

    static std::uint32_t wrap(Wrap w) {
        switch (w) {
        case Wrap::repeat: return WRAP_REPEAT;
        case Wrap::mirror: return WRAP_MIRROR;
        case Wrap::clamp: return WRAP_CLAMP;
        }
        return WRAP_REPEAT;
    }

    std::uint32_t upload(std::uint32_t image_index) {
        if (first_texel_[image_index] != NO_INDEX) return first_texel_[image_index];
        const TextureImage& image = scene_.images[image_index];
        const std::size_t first = table_.texels.size();
        const std::size_t count = std::size_t{image.width} * image.height;
        if (first + count > 0x7fffffffu)
            throw Error(
                fmt::format("image {} '{}': all textures together have more than {} texels (shrink some)",
                            image_index, image.name, 0x7fffffffu));
        table_.texels.resize(first + count);
        std::memcpy(table_.texels.data() + first, image.rgba.data(), count * 4);
        return first_texel_[image_index] = static_cast<std::uint32_t>(first);
    }

    const Scene& scene_;
    MaterialTable table_;
    std::vector<std::uint32_t> first_texel_; // by image
};

} // namespace

MaterialTable build_material_table(const Scene& scene) { return Builder(scene).build(); }

std::uint32_t triangle_flags(const Material& material, bool cull_backfaces) {
    const bool unsure =
        material.alpha_mode != AlphaMode::opaque || (cull_backfaces && !material.double_sided);
    const bool emits = material.unlit || material.emission != glm::vec3(0);
    const bool black = glm::vec3(material.base_color) == glm::vec3(0) && material.specular == 0 &&
                       material.metallic == 0; // textures and vertex colours are factors, too
    return (unsure ? TRIANGLE_ALPHA : 0u) | (emits ? TRIANGLE_EMITS : 0u) |
           (black || material.unlit ? 0u : TRIANGLE_SCATTERS);
}

} // namespace ajar
