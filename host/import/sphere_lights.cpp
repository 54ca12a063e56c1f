// The sphere is fitted by least squares on |p|^2 = 2 c p + (r^2 - |c|^2), which is linear in c and r^2 -
// |c|^2 and exact where there is one, however its vertices are spread.
#include "import/sphere_lights.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace ajar::gltf {

namespace {

constexpr double TOLERANCE = 0.01; // of a radius

template <class Visit> void for_corners(const Mesh& mesh, const Visit& visit) {
    for (const glm::uvec3& triangle : mesh.triangles)
        for (int k = 0; k < 3; ++k) visit(glm::dvec3(mesh.positions[triangle[k]]));
}

std::string emission_flaw(const Mesh& mesh, const std::vector<Material>& materials) {
    for (const std::uint32_t material : mesh.triangle_materials)
        if (material != mesh.triangle_materials[0]) return "it has more than one material";
    const Material& m = materials[mesh.triangle_materials[0]];
    if (m.emission == glm::vec3(0) || m.unlit) return "its material does not emit";
    if (m.emission_texture.used() || m.alpha_mode != AlphaMode::opaque)
        return "its emission is not the same everywhere";
    return {};
}

// In units of `scale` about `origin`; none where the corners do not span space.
std::optional<glm::dvec3> fit_center(const Mesh& mesh, const glm::dvec3& origin, double scale) {
    glm::dmat4 normal(0);
    glm::dvec4 right(0);
    for_corners(mesh, [&](const glm::dvec3& corner) {
        const glm::dvec3 p = (corner - origin) / scale;
        const glm::dvec4 row(2.0 * p, 1);
        for (int c = 0; c < 4; ++c) normal[c] += row * row[c];
        right += row * glm::dot(p, p);
    });
    normal /= 3.0 * static_cast<double>(mesh.triangles.size());
    right /= 3.0 * static_cast<double>(mesh.triangles.size());
    if (!(std::abs(glm::determinant(normal)) > 1e-9)) return std::nullopt;
    return glm::dvec3(glm::inverse(normal) * right);
}

// As seen from `center`, outward faces positive (Van Oosterom and Strackee 1983): 4 pi where the mesh is
// closed around it once.
double solid_angle_around(const Mesh& mesh, const glm::dvec3& center) {
    double sum = 0;
    for (const glm::uvec3& t : mesh.triangles) {
        const glm::dvec3 a = glm::normalize(glm::dvec3(mesh.positions[t.x]) - center);
        const glm::dvec3 b = glm::normalize(glm::dvec3(mesh.positions[t.y]) - center);
        const glm::dvec3 c = glm::normalize(glm::dvec3(mesh.positions[t.z]) - center);
        sum += 2 * std::atan2(glm::dot(a, glm::cross(b, c)),
                              1 + glm::dot(a, b) + glm::dot(b, c) + glm::dot(c, a));
    }
    return sum;
}

} // namespace

FittedSphere fit_sphere(const Mesh& mesh, const std::vector<Material>& materials) {
    FittedSphere sphere;
    sphere.flaw = emission_flaw(mesh, materials);
    if (!sphere.flaw.empty()) return sphere;
    sphere.flaw = "its vertices do not lie on a sphere within 1 %";
    Bounds bounds;
    for_corners(mesh, [&](const glm::dvec3& corner) { bounds.include(glm::vec3(corner)); });
    const glm::dvec3 origin = 0.5 * (glm::dvec3(bounds.lower) + glm::dvec3(bounds.upper));
    const double scale = 0.5 * glm::length(glm::dvec3(bounds.upper) - glm::dvec3(bounds.lower));
    const auto center = scale > 0 ? fit_center(mesh, origin, scale) : std::nullopt;
    if (!center) return sphere;
    const glm::dvec3 middle = origin + *center * scale;
    double nearest = INFINITY;
    double farthest = 0;
    for_corners(mesh, [&](const glm::dvec3& corner) {
        nearest = std::min(nearest, glm::length(corner - middle));
        farthest = std::max(farthest, glm::length(corner - middle));
    });
    if (!(nearest >= farthest * (1 - TOLERANCE) / (1 + TOLERANCE))) return sphere;
    sphere.center = glm::vec3(middle);
    // The centre has been rounded.
    sphere.radius = static_cast<float>(farthest * (1 + 0x1p-22) + 0x1p-23 * glm::length(middle));
    const double around = solid_angle_around(mesh, middle) / (4 * std::numbers::pi);
    const bool closed = std::abs(std::abs(around) - 1) < TOLERANCE;
    sphere.flaw = !closed ? "it is not closed" : around < 0 ? "it faces inwards" : "";
    return sphere;
}

void SphereLights::mark(Instance& instance) {
    const auto [entry, is_new] = fitted_.try_emplace(instance.mesh);
    FittedSphere& sphere = entry->second;
    const auto warn = [&](const std::string& flaw) {
        document_.warn(fmt::format("node '{}': extras.ajar_sphere is ignored: {}", instance.name, flaw));
    };
    if (is_new) {
        sphere = fit_sphere(scene_.meshes[instance.mesh], scene_.materials);
        if (!sphere.flaw.empty()) warn(sphere.flaw);
    }
    if (!sphere.flaw.empty()) return;
    const glm::dmat3 m(instance.to_world);
    const glm::dmat3 gram = glm::transpose(m) * m; // scale^2 times the identity, if the sphere stays one
    const double scale2 = (gram[0][0] + gram[1][1] + gram[2][2]) / 3;
    double most = 0; // bounds the largest eigenvalue
    for (int c = 0; c < 3; ++c) {
        most = std::max(most, std::abs(gram[c][0]) + std::abs(gram[c][1]) + std::abs(gram[c][2]));
        for (int r = 0; r < 3; ++r)
            if (!(std::abs(gram[c][r] - (r == c ? scale2 : 0)) <= 2 * TOLERANCE * scale2))
                return warn("its node scales it unevenly");
    }
    instance.sphere_center = glm::vec3(instance.to_world * glm::vec4(sphere.center, 1));
    instance.sphere_radius = static_cast<float>(sphere.radius * std::sqrt(most));
}

} // namespace ajar::gltf
