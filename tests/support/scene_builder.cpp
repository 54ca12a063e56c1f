#include "support/scene_builder.hpp"

#include <algorithm>
#include <array>
#include <glm/gtc/constants.hpp>
#include <map>
#include <utility>

namespace ajar::test {

namespace {

// Camera to world: looks along -Z.
glm::mat4 look_at(glm::vec3 eye, glm::vec3 target) {
    const glm::vec3 back = glm::normalize(eye - target);
    const glm::vec3 up = std::abs(back.y) > 0.999f ? glm::vec3(0, 0, -1) : glm::vec3(0, 1, 0);
    const glm::vec3 x = glm::normalize(glm::cross(up, back));
    return glm::mat4(glm::vec4(x, 0), glm::vec4(glm::cross(back, x), 0), glm::vec4(back, 0),
                     glm::vec4(eye, 1));
}

void append_quad(Mesh& mesh, const std::array<glm::vec3, 4>& corners) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    const glm::vec3 n = glm::normalize(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
    mesh.positions.insert(mesh.positions.end(), corners.begin(), corners.end());
    mesh.normals.insert(mesh.normals.end(), 4, n);
    mesh.uv0.insert(mesh.uv0.end(), {{0, 0}, {1, 0}, {1, 1}, {0, 1}});
    mesh.triangles.emplace_back(first, first + 1, first + 2);
    mesh.triangles.emplace_back(first, first + 2, first + 3);
}

// The six faces of a box; `outward` decides which side is the front.
Mesh box_mesh(glm::vec3 lower, glm::vec3 upper, bool outward) {
    Mesh mesh;
    for (int axis = 0; axis < 3; ++axis) {
        for (const bool high : {false, true}) {
            const int u = (axis + 1) % 3;
            const int v = (axis + 2) % 3;
            std::array<glm::vec3, 4> corners;
            for (std::size_t k = 0; k < 4; ++k) {
                corners[k][axis] = high ? upper[axis] : lower[axis];
                corners[k][u] = k == 1 || k == 2 ? upper[u] : lower[u];
                corners[k][v] = k >= 2 ? upper[v] : lower[v];
            }
            // In this order the front faces +axis: outward where `high`.
            if (high != outward) std::swap(corners[1], corners[3]);
            append_quad(mesh, corners);
        }
    }
    return mesh;
}

struct UnitSphere {
    std::vector<glm::dvec3> points;
    std::vector<glm::uvec3> triangles; // counter-clockwise from outside
};

UnitSphere icosahedron() {
    UnitSphere sphere;
    const double golden = 0.5 * (1 + std::sqrt(5.0));
    for (const double s : {-1.0, 1.0})
        for (const double t : {-golden, golden})
            for (const glm::dvec3& p : {glm::dvec3(0, s, t), glm::dvec3(s, t, 0), glm::dvec3(t, 0, s)})
                sphere.points.push_back(glm::normalize(p));
    // Faces join points one edge apart; the edge is 1.0515, the next distance 1.7013.
    const auto joined = [&](std::uint32_t i, std::uint32_t j) {
        return glm::distance(sphere.points[i], sphere.points[j]) < 1.2;
    };
    for (std::uint32_t a = 0; a < 12; ++a)
        for (std::uint32_t b = a + 1; b < 12; ++b)
            for (std::uint32_t c = b + 1; c < 12; ++c) {
                if (!joined(a, b) || !joined(b, c) || !joined(c, a)) continue;
                const glm::dvec3& p = sphere.points[a];
                const bool outward = glm::dot(glm::cross(sphere.points[b] - p, sphere.points[c] - p), p) > 0;
                sphere.triangles.push_back(outward ? glm::uvec3(a, b, c) : glm::uvec3(a, c, b));
            }
    return sphere;
}

UnitSphere subdivide(UnitSphere coarse) {
    UnitSphere fine;
    fine.points = std::move(coarse.points);
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
        const auto [at, inserted] =
            middles.try_emplace(std::minmax(a, b), static_cast<std::uint32_t>(fine.points.size()));
        if (inserted) fine.points.push_back(glm::normalize(fine.points[a] + fine.points[b]));
        return at->second;
    };
    for (const glm::uvec3& t : coarse.triangles) {
        const std::uint32_t ab = middle(t.x, t.y);
        const std::uint32_t bc = middle(t.y, t.z);
        const std::uint32_t ca = middle(t.z, t.x);
        for (const glm::uvec3& part : {glm::uvec3(t.x, ab, ca), glm::uvec3(ab, t.y, bc),
                                       glm::uvec3(ca, bc, t.z), glm::uvec3(ab, bc, ca)})
            fine.triangles.push_back(part);
    }
    return fine;
}

} // namespace

Material lambert(glm::vec3 albedo) {
    Material material;
    material.name = "lambert";
    material.base_color = glm::vec4(albedo, 1);
    material.metallic = 0;
    material.roughness = 1;
    material.specular = 0;
    return material;
}

Material emitter(glm::vec3 radiance) { return glowing_lambert(glm::vec3(0), radiance); }

Material glowing_lambert(glm::vec3 albedo, glm::vec3 radiance) {
    Material material = lambert(albedo);
    material.emission = radiance;
    return material;
}

Material metal(glm::vec3 color, float roughness) {
    Material material;
    material.name = "metal";
    material.base_color = glm::vec4(color, 1);
    material.metallic = 1;
    material.roughness = roughness;
    return material;
}

Material plastic(glm::vec3 color, float roughness) {
    Material material = metal(color, roughness);
    material.name = "plastic";
    material.metallic = 0;
    return material;
}

std::uint32_t SceneBuilder::material(Material material) {
    scene_.materials.push_back(std::move(material));
    return static_cast<std::uint32_t>(scene_.materials.size() - 1);
}

void SceneBuilder::add(Mesh mesh, std::uint32_t material) {
    mesh.triangle_materials.assign(mesh.triangles.size(), material);
    Instance instance;
    instance.mesh = static_cast<std::uint32_t>(scene_.meshes.size());
    instance.name = mesh.name;
    scene_.instances.push_back(std::move(instance));
    scene_.meshes.push_back(std::move(mesh));
}

void SceneBuilder::quad(glm::vec3 a, glm::vec3 b, glm::vec3 c, glm::vec3 d, std::uint32_t material) {
    Mesh mesh;
    append_quad(mesh, {a, b, c, d});
    add(std::move(mesh), material);
}

void SceneBuilder::square(glm::vec3 center, glm::vec3 normal, float half_side, std::uint32_t material) {
    const glm::vec3 axis = std::abs(normal.x) > 0.5f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
    const glm::vec3 s = half_side * glm::normalize(axis - glm::dot(axis, normal) * normal);
    const glm::vec3 t = glm::cross(normal, s);
    quad(center - s - t, center + s - t, center + s + t, center - s + t, material);
}

void SceneBuilder::box(glm::vec3 lower, glm::vec3 upper, std::uint32_t material) {
    add(box_mesh(lower, upper, true), material);
}

void SceneBuilder::room(glm::vec3 lower, glm::vec3 upper, std::uint32_t material) {
    add(box_mesh(lower, upper, false), material);
}

void SceneBuilder::sphere(glm::vec3 center, float radius, int subdivisions, Normals normals,
                          std::uint32_t material) {
    UnitSphere unit = icosahedron();
    for (int i = 0; i < subdivisions; ++i) unit = subdivide(std::move(unit));
    Mesh mesh;
    const auto place = [&](const glm::dvec3& p, const glm::dvec3& n) {
        mesh.positions.push_back(center + radius * glm::vec3(p));
        mesh.normals.emplace_back(n);
        return static_cast<std::uint32_t>(mesh.positions.size() - 1);
    };
    if (normals == Normals::smooth) {
        for (const glm::dvec3& p : unit.points) place(p, p);
        mesh.triangles = unit.triangles;
    } else {
        for (const glm::uvec3& t : unit.triangles) {
            const glm::dvec3& a = unit.points[t.x];
            const glm::dvec3& b = unit.points[t.y];
            const glm::dvec3& c = unit.points[t.z];
            const glm::dvec3 n = glm::normalize(glm::cross(b - a, c - a));
            const std::uint32_t first = place(a, n);
            place(b, n);
            place(c, n);
            mesh.triangles.emplace_back(first, first + 1, first + 2);
        }
    }
    add(std::move(mesh), material);
}

void SceneBuilder::sphere_light(glm::vec3 center, float radius, std::uint32_t material) {
    sphere(center, radius, 3, Normals::smooth, material);
    scene_.instances.back().sphere_center = center;
    scene_.instances.back().sphere_radius = radius;
}

void SceneBuilder::point_light(glm::vec3 position, glm::vec3 intensity, float radius) {
    Light light;
    light.radius = radius;
    light.kind = LightKind::point;
    light.position = position;
    light.intensity = intensity;
    scene_.lights.push_back(light);
}

void SceneBuilder::spot_light(glm::vec3 position, glm::vec3 direction, glm::vec3 intensity, float inner,
                              float outer, float radius) {
    point_light(position, intensity, radius);
    Light& light = scene_.lights.back();
    light.kind = LightKind::spot;
    light.direction = glm::normalize(direction);
    light.inner_cone_angle = inner;
    light.outer_cone_angle = outer;
}

void SceneBuilder::directional_light(glm::vec3 direction, glm::vec3 irradiance, float angular_diameter) {
    Light light;
    light.angular_diameter = angular_diameter;
    light.kind = LightKind::directional;
    light.direction = glm::normalize(direction);
    light.intensity = irradiance;
    scene_.lights.push_back(light);
}

void SceneBuilder::constant_environment(glm::vec3 radiance) {
    Environment environment;
    environment.name = "constant";
    environment.scale = radiance;
    scene_.environment = std::move(environment);
}

std::uint32_t SceneBuilder::texture(std::uint32_t width, std::uint32_t height, std::vector<std::uint8_t> rgba,
                                    TextureFilter filter) {
    TextureImage image;
    image.width = width;
    image.height = height;
    image.rgba = std::move(rgba);
    scene_.images.push_back(std::move(image));
    Texture texture;
    texture.image = static_cast<std::uint32_t>(scene_.images.size() - 1);
    texture.filter = filter;
    scene_.textures.push_back(texture);
    return static_cast<std::uint32_t>(scene_.textures.size() - 1);
}

void SceneBuilder::perspective(glm::vec3 eye, glm::vec3 target, float yfov) {
    Camera camera;
    camera.kind = CameraKind::perspective;
    camera.yfov = yfov;
    camera.to_world = look_at(eye, target);
    scene_.cameras.push_back(camera);
}

void SceneBuilder::orthographic(glm::vec3 eye, glm::vec3 target, float ymag) {
    Camera camera;
    camera.kind = CameraKind::orthographic;
    camera.ymag = ymag;
    camera.to_world = look_at(eye, target);
    scene_.cameras.push_back(camera);
}

Scene SceneBuilder::build() const {
    validate(scene_);
    return scene_;
}

glm::vec3 environment_direction(std::uint32_t i, std::uint32_t j, std::uint32_t width, std::uint32_t height) {
    const double theta = glm::pi<double>() * (j + 0.5) / height;
    const double phi = glm::two_pi<double>() * ((i + 0.5) / width - 0.5);
    return {std::sin(theta) * std::cos(phi), std::cos(theta), std::sin(theta) * std::sin(phi)};
}

} // namespace ajar::test
