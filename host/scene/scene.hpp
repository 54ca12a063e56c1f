// A scene as plain data: what an importer produces and a renderer consumes. No GPU, no files. Units are
// glTF's: metres, radians, right-handed, +Y up; colours are linear Rec. 709 unless said otherwise.
#pragma once

#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

namespace ajar {

inline constexpr std::uint32_t NO_INDEX = 0xffffffffu;

// Eight-bit RGBA, row 0 at the top, as stored in the file: whether texels are sRGB is decided by their use.
struct TextureImage {
    std::string name;
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::vector<std::uint8_t> rgba; // width * height * 4
};

enum class Wrap : std::uint8_t { repeat, mirror, clamp };
enum class TextureFilter : std::uint8_t { linear, nearest };

struct Texture {
    std::string name;
    std::uint32_t image = 0; // Scene::images
    Wrap wrap_u = Wrap::repeat;
    Wrap wrap_v = Wrap::repeat;
    TextureFilter filter = TextureFilter::linear;
};

// A use of a texture by a material. (u, v) are transformed by rows of `uv_transform` applied to (u, v, 1).
struct TextureUse {
    std::uint32_t texture = NO_INDEX; // Scene::textures; NO_INDEX: no texture, the factor alone
    std::uint32_t uv_set = 0;         // 0 or 1
    glm::vec3 uv_row_u{1, 0, 0};
    glm::vec3 uv_row_v{0, 1, 0};
    bool used() const { return texture != NO_INDEX; }
};

enum class AlphaMode : std::uint8_t { opaque, mask, blend };

// glTF 2.0 metallic-roughness (specification, section 3.9 and appendix B).
struct Material {
    std::string name;
    glm::vec4 base_color{1, 1, 1, 1}; // times the texture (sRGB) and the vertex colour
    TextureUse base_color_texture;
    float metallic = 1;  // times the texture's B
    float roughness = 1; // perceptual; times the texture's G. alpha = roughness^2
    TextureUse metallic_roughness_texture;
    float normal_scale = 1;
    TextureUse normal_texture;
    float occlusion_strength = 1; // kept for info; a path tracer computes its own occlusion
    TextureUse occlusion_texture;
    glm::vec3 emission{0, 0, 0}; // radiance, emissiveFactor * emissiveStrength; times the texture (sRGB)
    TextureUse emission_texture;
    float ior = 1.5f;
    float specular = 1;                // KHR_materials_specular: scales F0 and F90 of the dielectric
    glm::vec3 specular_color{1, 1, 1}; // tints F0 of the dielectric
    AlphaMode alpha_mode = AlphaMode::opaque;
    float alpha_cutoff = 0.5f;
    bool double_sided = false;
    bool unlit = false;
};

// One glTF mesh: the triangles of all its primitives. `positions` and `normals` have the same length; the
// other attributes are empty or of that length too.
struct Mesh {
    std::string name;
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;  // unit
    std::vector<glm::vec4> tangents; // xyz unit, w = handedness (+1 or -1): bitangent = w * cross(n, t)
    std::vector<glm::vec2> uv0;
    std::vector<glm::vec2> uv1;
    std::vector<glm::vec4> colors; // linear RGBA
    std::vector<glm::uvec3> triangles;
    std::vector<std::uint32_t> triangle_materials; // Scene::materials, one per triangle
};

// A mesh placed in the world. Its index in Scene::instances is the object id of the AOVs. The front of a
// triangle is where its corners run counter-clockwise, in the mesh's space: a transform of negative
// determinant, which mirrors, turns them clockwise in the world and the front stays the front (glTF 2.0,
// section 3.7.4).
struct Instance {
    std::string name; // the node's
    std::uint32_t mesh = 0;
    glm::mat4 to_world{1};
    // Above 0: it emits as this sphere, which holds all its vertices, instead of by its triangles:
    // outwards, the emission of its first triangle's material. World, metres.
    float sphere_radius = 0;
    glm::vec3 sphere_center{0, 0, 0};
};

enum class LightKind : std::uint8_t { point, spot, directional };

// KHR_lights_punctual, in world space.
struct Light {
    std::string name;
    LightKind kind = LightKind::point;
    glm::vec3 intensity{
        1, 1, 1}; // colour * intensity: W/sr (point, spot) or W/m^2 at normal incidence (directional)
    glm::vec3 position{0, 0, 0};
    glm::vec3 direction{0, 0, -1}; // unit, along which the light travels
    float range = 0;            // metres; 0: unlimited. Beyond it the light is cut off as the extension says
    float inner_cone_angle = 0; // radians from the axis
    float outer_cone_angle = 0.785398163f;
    float radius = 0;           // metres; point, spot: of a sphere of that intensity; 0: a point
    float angular_diameter = 0; // radians; directional: of the disk that it comes from; 0: parallel
};

enum class CameraKind : std::uint8_t { perspective, orthographic };

// Looks along its -Z with +Y up. The image's aspect is the image's own; `yfov` and `ymag` hold.
struct Camera {
    std::string name;
    CameraKind kind = CameraKind::perspective;
    float yfov = 0.8f;     // radians, whole vertical angle
    float ymag = 1;        // half the vertical extent of an orthographic view, metres
    glm::mat4 to_world{1}; // rigid: scale removed
};

// Radiance from all around: an equirectangular map (u = atan2(z, x) / 2 pi + 1/2, v = 0 at +Y, row 0 at v =
// 0) times `scale`, or the constant `scale` where `radiance` is empty. `rotation` turns the map about +Y,
// in radians.
struct Environment {
    std::string name;
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::vector<glm::vec3> radiance; // width * height
    glm::vec3 scale{1, 1, 1};
    float rotation = 0;
};

struct Scene {
    std::string name;
    std::vector<Mesh> meshes;
    std::vector<Instance> instances;
    std::vector<Material> materials;
    std::vector<Texture> textures;
    std::vector<TextureImage> images;
    std::vector<Light> lights;
    std::vector<Camera> cameras;
    std::uint32_t camera = 0; // the one to render from
    std::optional<Environment> environment;
};

struct Bounds {
    glm::vec3 lower{INFINITY, INFINITY, INFINITY};
    glm::vec3 upper{-INFINITY, -INFINITY, -INFINITY};
    bool empty() const { return lower.x > upper.x; }
    void include(const glm::vec3& p) { lower = glm::min(lower, p), upper = glm::max(upper, p); }
};

// World-space box of all instances.
Bounds scene_bounds(const Scene& scene);

// False where every pixel would be black: no light, no environment, no placed triangle that emits or is
// unlit.
bool has_light(const Scene& scene);

// Bytes of host memory that the scene's arrays take.
std::uint64_t memory_bytes(const Scene& scene);

// Checks what every consumer relies on: indices in range, attribute lengths, finite numbers. Throws Error
// naming the part ("mesh 3 'wheel': triangle 7: ...").
void validate(const Scene& scene);

// A perspective camera (yfov 40 degrees) that sees the whole scene for any aspect of at least `aspect`.
Camera framing_camera(const Scene& scene, float aspect);

} // namespace ajar
