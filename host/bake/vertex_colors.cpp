#include "bake/vertex_colors.hpp"

#include "bake/unlit.hpp"
#include "radiosity/index_table.hpp"
#include "radiosity/smooth_vertices.hpp"

#include <algorithm>
#include <bit>
#include <cstring>
#include <glm/gtc/constants.hpp>
#include <utility>

namespace ajar {

namespace {

// Below this mean a texture counts as black: what it multiplies cannot be told from it.
constexpr float DARKEST = 1e-3f;

// What the base colour's texture has to be multiplied by at each corner of each patch so that the product is
// the radiance there: reflectance and emission by the texture's own mean.
class CornerFactors {
  public:
    CornerFactors(const PatchMesh& mesh, const SmoothVertices& smooth, const ElementLight& light)
        : values_(3 * mesh.patches.size()) {
        // Means over the patches of one material around a smooth vertex.
        std::vector<std::pair<std::uint64_t, std::uint32_t>> corners;
        for (std::uint32_t p = 0; p < mesh.patches.size(); ++p)
            for (std::uint32_t k = 0; k < 3; ++k) {
                const std::uint64_t vertex = smooth.vertex(2 * p + shared::PATCH_FRONT, k);
                corners.emplace_back(vertex << 32 | mesh.sources[mesh.patches[p].source].material, 3 * p + k);
            }
        std::sort(corners.begin(), corners.end());
        for (std::size_t first = 0, end = 0; first < corners.size(); first = end) {
            Factors sum;
            float area = 0;
            for (end = first; end < corners.size() && corners[end].first == corners[first].first; ++end) {
                const std::uint32_t p = corners[end].second / 3;
                const float weight = mesh.patches[p].area;
                const glm::vec3 texture = glm::max(light.textures[p].color, DARKEST);
                sum.reflectance += weight * light.materials.reflectance[p] / texture;
                sum.emission += weight * light.materials.emission[p] / texture;
                area += weight;
            }
            for (std::size_t i = first; i < end; ++i)
                values_[corners[i].second] = {sum.reflectance / area, sum.emission / area};
        }
    }

    struct Factors {
        glm::vec3 reflectance{0};
        glm::vec3 emission{0};
    };
    const Factors& at(std::uint32_t patch, std::uint32_t corner) const { return values_[3 * patch + corner]; }

  private:
    std::vector<Factors> values_;
};

struct Vertex {
    glm::vec3 position, normal;
    glm::vec2 uv0, uv1;
    glm::vec4 color;
    bool operator==(const Vertex&) const = default;
};

// A mesh whose equal vertices are one.
class MeshBuilder {
  public:
    explicit MeshBuilder(const std::string& name) { mesh_.name = name; }

    void begin_material(std::uint32_t material) { material_ = material, table_ = {}; }
    void add_triangle(const Vertex (&corners)[3]) {
        glm::uvec3 t;
        for (int k = 0; k < 3; ++k) t[k] = index(corners[k]);
        mesh_.triangles.push_back(t);
        mesh_.triangle_materials.push_back(material_);
    }
    bool empty() const { return mesh_.triangles.empty(); }
    Mesh finish() {
        const auto none = [](const glm::vec2& uv) { return uv == glm::vec2(0); };
        const auto all_none = [&](const std::vector<glm::vec2>& uv) {
            return std::all_of(uv.begin(), uv.end(), none);
        };
        if (all_none(mesh_.uv0)) mesh_.uv0.clear();
        if (all_none(mesh_.uv1)) mesh_.uv1.clear();
        return std::move(mesh_);
    }

  private:
    std::uint32_t index(const Vertex& v) {
        const auto hash = [](const Vertex& vertex) {
            std::uint32_t words[sizeof(Vertex) / 4];
            std::memcpy(words, &vertex, sizeof words);
            std::uint64_t h = 0;
            for (const std::uint32_t word : words) h = IndexTable::mix(h + word);
            return h;
        };
        const auto stored = [&](std::uint32_t i) {
            return Vertex{mesh_.positions[i], mesh_.normals[i], mesh_.uv0[i], mesh_.uv1[i], mesh_.colors[i]};
        };
        return table_.find_or_make(
            hash(v), [&](std::uint32_t i) { return stored(i) == v; },
            [&] {
                mesh_.positions.push_back(v.position);
                mesh_.normals.push_back(v.normal);
                mesh_.uv0.push_back(v.uv0);
                mesh_.uv1.push_back(v.uv1);
                mesh_.colors.push_back(v.color);
                return static_cast<std::uint32_t>(mesh_.positions.size() - 1);
            },
            [&](std::uint32_t i) { return hash(stored(i)); });
    }

    Mesh mesh_;
    IndexTable table_;
    std::uint32_t material_ = 0;
};

template <class T> T at_corner(const std::vector<T>& values, const glm::uvec3& t, const glm::vec2& at) {
    return (1 - at.x - at.y) * values[t.x] + at.x * values[t.y] + at.y * values[t.z];
}

// All but the colour.
Vertex vertex_of(const Scene& scene, const PatchMesh& mesh, const Patch& patch, int corner) {
    const PatchSource& source = mesh.sources[patch.source];
    const Instance& instance = scene.instances[source.instance];
    const Mesh& shape = scene.meshes[instance.mesh];
    const Material& material = scene.materials[source.material];
    const glm::uvec3 t = PatchMesh::mesh_triangle(scene, source);
    const glm::vec2 at = patch.corners[corner];
    const glm::mat3 normal_to_world = glm::transpose(glm::inverse(glm::mat3(instance.to_world)));
    const glm::vec3 normal = normal_to_world * at_corner(shape.normals, t, at);
    Vertex v{mesh.positions[patch.vertices[corner]], patch.normal, {0, 0}, {0, 0}, {0, 0, 0, 1}};
    if (std::isnormal(glm::dot(normal, normal))) v.normal = glm::normalize(normal);
    const TextureUse& use = material.base_color_texture;
    if (use.used() && use.uv_set == 0 && !shape.uv0.empty()) v.uv0 = at_corner(shape.uv0, t, at);
    if (use.used() && use.uv_set == 1 && !shape.uv1.empty()) v.uv1 = at_corner(shape.uv1, t, at);
    if (!shape.colors.empty()) v.color.w = std::clamp(at_corner(shape.colors, t, at).w, 0.0f, 1.0f);
    return v;
}

} // namespace

std::vector<SceneElement> patch_elements(const Scene& scene, const PatchMesh& mesh) {
    std::vector<SceneElement> elements;
    elements.reserve(mesh.patches.size());
    for (const Patch& patch : mesh.patches) {
        const PatchSource& source = mesh.sources[patch.source];
        SceneElement e{source.instance,
                       source.triangle,
                       0,
                       patch.corners[0],
                       patch.corners[1] - patch.corners[0],
                       patch.corners[2] - patch.corners[0]};
        // Patches count a mirrored triangle's corners as the world sees them, elements as its mesh does.
        if (mirrors(scene.instances[source.instance].to_world))
            for (glm::vec2* uv : {&e.origin, &e.edge_a, &e.edge_b}) std::swap(uv->x, uv->y);
        elements.push_back(e);
    }
    return elements;
}

Scene vertex_colored_scene(const Scene& scene, const PatchMesh& mesh, const ElementLight& light,
                           float exposure, Brightness& brightness) {
    const SmoothVertices smooth(mesh);
    const CornerFactors factors(mesh, smooth, light);
    std::vector<glm::vec3> by_side(2 * mesh.patches.size());
    std::vector<std::uint8_t> active(by_side.size());
    for (std::size_t p = 0; p < mesh.patches.size(); ++p) {
        by_side[2 * p + shared::PATCH_FRONT] = light.irradiance[p];
        active[2 * p + shared::PATCH_FRONT] = 1;
    }
    const std::vector<glm::vec3> at_vertices = smooth.mean(mesh, by_side, active);

    Scene result;
    result.name = scene.name;
    result.cameras = scene.cameras;
    result.camera = scene.camera;
    result.textures = scene.textures;
    result.images = scene.images;
    for (const Material& m : scene.materials)
        result.materials.push_back(
            unlit_material(m, glm::vec4(1, 1, 1, m.base_color.w), m.base_color_texture));
    const auto source_of = [&](std::uint32_t patch) { return mesh.sources[mesh.patches[patch].source]; };
    for (std::uint32_t first = 0, end = 0; first < mesh.patches.size(); first = end) {
        const std::uint32_t instance = source_of(first).instance;
        std::vector<std::uint32_t> patches;
        for (end = first; end < mesh.patches.size() && source_of(end).instance == instance; ++end)
            patches.push_back(end);
        std::stable_sort(patches.begin(), patches.end(), [&](std::uint32_t a, std::uint32_t b) {
            return source_of(a).material < source_of(b).material;
        });
        MeshBuilder builder(scene.meshes[scene.instances[instance].mesh].name);
        std::uint32_t material = NO_INDEX;
        for (const std::uint32_t p : patches) {
            if (source_of(p).material != material) builder.begin_material(material = source_of(p).material);
            Vertex corners[3];
            for (std::uint32_t k = 0; k < 3; ++k) {
                corners[k] = vertex_of(scene, mesh, mesh.patches[p], static_cast<int>(k));
                const CornerFactors::Factors& f = factors.at(p, k);
                const glm::vec3 irradiance = at_vertices[smooth.vertex(2 * p + shared::PATCH_FRONT, k)];
                const glm::vec3 color = brightness.stored(f.reflectance * irradiance / glm::pi<float>(),
                                                          f.emission, exposure, light.textures[p].color);
                corners[k].color = glm::vec4(color, corners[k].color.w);
            }
            builder.add_triangle(corners);
        }
        result.instances.push_back(
            {scene.instances[instance].name, static_cast<std::uint32_t>(result.meshes.size()), glm::mat4(1)});
        result.meshes.push_back(builder.finish());
    }
    remove_unused(result);
    return result;
}

} // namespace ajar
