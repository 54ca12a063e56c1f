#include "bake/lightmap.hpp"

#include "bake/unlit.hpp"
#include "image/srgb.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace ajar {

namespace {

template <class T> void copy_vertex(const std::vector<T>& from, std::uint32_t vertex, std::vector<T>& to) {
    if (!from.empty()) to.push_back(from[vertex]);
}

// Which texture coordinates a material's textures use, and what becomes of them.
enum class UvSets : std::uint8_t {
    first,  // stays, the second is the atlas'
    second, // becomes the first
    both,   // stay: there is no room for the atlas'
};

UvSets uv_sets(const Material& m) {
    bool first = false, second = false;
    for (const TextureUse* use :
         {&m.base_color_texture, &m.metallic_roughness_texture, &m.normal_texture, &m.emission_texture})
        if (use->used()) (use->uv_set == 1 ? second : first) = true;
    return !second ? UvSets::first : first ? UvSets::both : UvSets::second;
}

// The triangles of one instance, sorted by material. A vertex that several charts share gets a copy for each.
// `sets` by material.
Mesh unwrapped_mesh(const Mesh& mesh, const Atlas& atlas, const std::vector<UvSets>& sets,
                    std::vector<std::uint32_t> triangles) {
    const auto material = [&](std::uint32_t t) {
        return mesh.triangle_materials[atlas.charts.triangles[t].triangle];
    };
    std::stable_sort(triangles.begin(), triangles.end(), [&](std::uint32_t a, std::uint32_t b) {
        return std::pair(material(a), atlas.charts.chart_of[a]) <
               std::pair(material(b), atlas.charts.chart_of[b]);
    });
    Mesh result;
    result.name = mesh.name;
    std::vector<std::uint32_t> copies(mesh.positions.size(), NO_INDEX); // for the present material and chart
    std::vector<std::uint32_t> copied;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        const std::uint32_t t = triangles[i];
        const bool is_same = i > 0 && material(t) == material(triangles[i - 1]) &&
                             atlas.charts.chart_of[t] == atlas.charts.chart_of[triangles[i - 1]];
        if (!is_same) {
            for (const std::uint32_t v : copied) copies[v] = NO_INDEX;
            copied.clear();
        }
        const glm::uvec3& corners = mesh.triangles[atlas.charts.triangles[t].triangle];
        glm::uvec3 again;
        for (int k = 0; k < 3; ++k) {
            const std::uint32_t v = corners[k];
            if (copies[v] == NO_INDEX) {
                copies[v] = static_cast<std::uint32_t>(result.positions.size());
                copied.push_back(v);
                copy_vertex(mesh.positions, v, result.positions);
                copy_vertex(mesh.normals, v, result.normals);
                copy_vertex(mesh.tangents, v, result.tangents);
                copy_vertex(mesh.colors, v, result.colors);
                const UvSets own = sets[material(t)];
                const std::vector<glm::vec2>& first = own == UvSets::second ? mesh.uv1 : mesh.uv0;
                result.uv0.push_back(first.empty() ? glm::vec2(0) : first[v]);
                const bool stays = own == UvSets::both && !mesh.uv1.empty();
                result.uv1.push_back(stays ? mesh.uv1[v] : atlas.uv(t, static_cast<std::size_t>(k)));
            }
            again[k] = copies[v];
        }
        result.triangles.push_back(again);
        result.triangle_materials.push_back(material(t));
    }
    return result;
}

Scene unwrapped(const Scene& scene, const Atlas& atlas, const std::vector<UvSets>& sets) {
    Scene result = scene;
    result.meshes.clear();
    result.instances.clear();
    const std::vector<PlacedTriangle>& triangles = atlas.charts.triangles;
    for (std::uint32_t first = 0, end = 0; first < triangles.size(); first = end) {
        std::vector<std::uint32_t> own;
        for (end = first; end < triangles.size() && triangles[end].instance == triangles[first].instance;
             ++end)
            own.push_back(end);
        Instance instance = scene.instances[triangles[first].instance];
        const Mesh& mesh = scene.meshes[instance.mesh];
        instance.mesh = static_cast<std::uint32_t>(result.meshes.size());
        result.meshes.push_back(unwrapped_mesh(mesh, atlas, sets, std::move(own)));
        result.instances.push_back(std::move(instance));
    }
    return result;
}

std::uint8_t to_byte(float value) {
    return static_cast<std::uint8_t>(std::lround(255 * std::clamp(value, 0.0f, 1.0f)));
}

// Of the second texture coordinates.
TextureUse add_atlas_texture(Scene& scene, const char* name, std::uint32_t side,
                             std::vector<std::uint8_t> rgba) {
    const auto image = static_cast<std::uint32_t>(scene.images.size());
    const auto texture = static_cast<std::uint32_t>(scene.textures.size());
    scene.images.push_back({name, side, side, std::move(rgba)});
    scene.textures.push_back({name, image, Wrap::clamp, Wrap::clamp, TextureFilter::linear});
    return {texture, 1};
}

// By texel of the whole atlas, gutter filled.
template <class Value>
std::vector<glm::vec4> whole_atlas(std::uint32_t side, std::span<const CoveredTexel> covered, Value&& value) {
    std::vector<glm::vec4> values(std::size_t{side} * side, glm::vec4(0, 0, 0, 1));
    std::vector<bool> has_value(values.size());
    for (std::size_t i = 0; i < covered.size(); ++i) {
        values[covered[i].texel] = value(i);
        has_value[covered[i].texel] = true;
    }
    fill_gutter(values, std::move(has_value), side);
    return values;
}

} // namespace

std::vector<SceneElement> texel_elements(const Atlas& atlas, std::span<const CoveredTexel> covered) {
    std::vector<SceneElement> elements;
    elements.reserve(covered.size());
    for (const CoveredTexel& texel : covered) {
        const PlacedTriangle& placed = atlas.charts.triangles[texel.triangle];
        elements.push_back({placed.instance, placed.triangle, shared::ELEMENT_QUAD, texel.origin,
                            texel.edge_x, texel.edge_y});
    }
    return elements;
}

Scene unwrapped_scene(const Scene& scene, const Atlas& atlas) {
    return unwrapped(scene, atlas, std::vector<UvSets>(scene.materials.size(), UvSets::first));
}

Scene unwrapped_scene_with_textures(const Scene& scene, const Atlas& atlas,
                                    std::vector<std::string>& without) {
    std::vector<UvSets> sets;
    for (const Material& m : scene.materials) sets.push_back(uv_sets(m));
    Scene result = unwrapped(scene, atlas, sets);
    for (std::size_t i = 0; i < sets.size(); ++i) {
        if (sets[i] == UvSets::both) without.push_back(scene.materials[i].name);
        if (sets[i] != UvSets::second) continue;
        Material& m = result.materials[i];
        for (TextureUse* use :
             {&m.base_color_texture, &m.metallic_roughness_texture, &m.normal_texture, &m.emission_texture})
            use->uv_set = 0;
    }
    return result;
}

Scene lightmapped_scene(Scene unwrapped, std::uint32_t side, std::span<const CoveredTexel> covered,
                        const ElementLight& light, float exposure, Brightness& brightness) {
    const std::vector<glm::vec4> values = whole_atlas(side, covered, [&](std::size_t i) {
        return glm::vec4(brightness.stored(light.reflected(i), light.materials.emission[i], exposure),
                         light.textures[i].alpha);
    });
    const bool has_alpha = std::any_of(unwrapped.materials.begin(), unwrapped.materials.end(),
                                       [](const Material& m) { return m.alpha_mode != AlphaMode::opaque; });
    std::vector<std::uint8_t> rgba;
    rgba.reserve(4 * values.size());
    for (const glm::vec4& value : values) {
        const glm::vec3 encoded = srgb_encode(glm::vec3(value));
        rgba.insert(rgba.end(), {to_byte(encoded.x), to_byte(encoded.y), to_byte(encoded.z),
                                 has_alpha ? to_byte(value.w) : std::uint8_t{255}});
    }
    unwrapped.textures.clear();
    unwrapped.images.clear();
    unwrapped.lights.clear();
    unwrapped.environment.reset();
    const TextureUse use = add_atlas_texture(unwrapped, "lightmap", side, std::move(rgba));
    for (Material& m : unwrapped.materials) m = unlit_material(m, glm::vec4(1), use);
    for (Mesh& mesh : unwrapped.meshes) mesh.colors.clear(), mesh.tangents.clear();
    for (Instance& instance : unwrapped.instances) instance.sphere_radius = 0;
    remove_unused(unwrapped);
    return unwrapped;
}

Image irradiance_image(std::uint32_t side, std::span<const CoveredTexel> covered,
                       std::span<const glm::vec3> irradiance) {
    Image image{side, side, {}, {}, Range::scene};
    Layer& layer = image.add("", {"R", "G", "B", "A"});
    const std::vector<glm::vec4> values =
        whole_atlas(side, covered, [&](std::size_t i) { return glm::vec4(irradiance[i], 1); });
    for (std::size_t i = 0; i < values.size(); ++i)
        for (int c = 0; c < 4; ++c) layer.pixels[4 * i + static_cast<std::size_t>(c)] = values[i][c];
    return image;
}

Scene occluded_scene(Scene unwrapped, std::uint32_t side, std::span<const CoveredTexel> covered,
                     std::span<const glm::vec3> openness) {
    const std::vector<glm::vec4> values =
        whole_atlas(side, covered, [&](std::size_t i) { return glm::vec4(openness[i], 1); });
    std::vector<std::uint8_t> rgba;
    rgba.reserve(4 * values.size());
    for (const glm::vec4& value : values) {
        const std::uint8_t open = to_byte(value.x);
        rgba.insert(rgba.end(), {open, open, open, 255});
    }
    const TextureUse use = add_atlas_texture(unwrapped, "occlusion", side, std::move(rgba));
    for (Material& m : unwrapped.materials) {
        if (uv_sets(m) == UvSets::both) continue;
        m.occlusion_texture = use;
        m.occlusion_strength = 1;
    }
    remove_unused(unwrapped);
    return unwrapped;
}

} // namespace ajar
