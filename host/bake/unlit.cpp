#include "bake/unlit.hpp"

#include <array>

namespace ajar {

namespace {

std::array<TextureUse*, 5> texture_uses(Material& m) {
    return {&m.base_color_texture, &m.metallic_roughness_texture, &m.normal_texture, &m.occlusion_texture,
            &m.emission_texture};
}

// Keeps what is used and gives its new indices.
template <class T> std::vector<std::uint32_t> keep(std::vector<T>& values, const std::vector<bool>& is_used) {
    std::vector<std::uint32_t> places(values.size(), NO_INDEX);
    std::vector<T> kept;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (!is_used[i]) continue;
        places[i] = static_cast<std::uint32_t>(kept.size());
        kept.push_back(std::move(values[i]));
    }
    values = std::move(kept);
    return places;
}

} // namespace

Material unlit_material(const Material& original, const glm::vec4& base_color,
                        const TextureUse& base_color_texture) {
    Material m;
    m.name = original.name;
    m.base_color = base_color;
    m.base_color_texture = base_color_texture;
    m.metallic = 0;
    m.roughness = 0.9f;
    m.alpha_mode = original.alpha_mode;
    m.alpha_cutoff = original.alpha_cutoff;
    m.double_sided = original.double_sided;
    m.unlit = true;
    return m;
}

void remove_unused(Scene& scene) {
    std::vector<bool> materials(scene.materials.size());
    for (const Mesh& mesh : scene.meshes)
        for (const std::uint32_t m : mesh.triangle_materials) materials[m] = true;
    const std::vector<std::uint32_t> material_places = keep(scene.materials, materials);
    for (Mesh& mesh : scene.meshes)
        for (std::uint32_t& m : mesh.triangle_materials) m = material_places[m];
    std::vector<bool> textures(scene.textures.size()), images(scene.images.size());
    for (Material& m : scene.materials)
        for (const TextureUse* use : texture_uses(m))
            if (use->used()) textures[use->texture] = true;
    const std::vector<std::uint32_t> texture_places = keep(scene.textures, textures);
    for (Material& m : scene.materials)
        for (TextureUse* use : texture_uses(m))
            if (use->used()) use->texture = texture_places[use->texture];
    for (const Texture& texture : scene.textures) images[texture.image] = true;
    const std::vector<std::uint32_t> image_places = keep(scene.images, images);
    for (Texture& texture : scene.textures) texture.image = image_places[texture.image];
}

} // namespace ajar
