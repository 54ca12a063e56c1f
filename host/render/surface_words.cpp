#include "render/surface_words.hpp"

#include "render/octahedral.hpp"
#include "shaders/shared/geometry.glsl.h"

#include <cmath>
#include <cstring>
#include <glm/gtc/matrix_inverse.hpp>

namespace ajar {

namespace {

using namespace shared;

std::uint32_t unorm16_pair(float low, float high) {
    const auto unorm = [](float x) {
        return static_cast<std::uint32_t>(std::lround(glm::clamp(x, 0.0f, 1.0f) * 65535.0f));
    };
    return unorm(low) | unorm(high) << 16;
}

glm::vec2 at_or_zero(const std::vector<glm::vec2>& values, std::uint32_t i) {
    return values.empty() ? glm::vec2(0) : values[i];
}

SurfaceExtension extension_of(const Mesh& mesh, const glm::uvec3& v, const glm::mat3& directions, bool flip) {
    SurfaceExtension e{};
    for (int k = 0; k < 3; ++k) {
        e.uv1[k] = at_or_zero(mesh.uv1, v[k]);
        const glm::vec4 color = mesh.colors.empty() ? glm::vec4(1) : mesh.colors[v[k]];
        e.color[2 * k] = unorm16_pair(color.r, color.g);
        e.color[2 * k + 1] = unorm16_pair(color.b, color.a);
        if (mesh.tangents.empty()) continue;
        const glm::vec4 tangent = mesh.tangents[v[k]];
        e.tangent[k] = octahedral_encode(directions * glm::vec3(tangent));
        if ((tangent.w < 0) != flip) e.tangent_sign |= 1u << k;
        e.tangent_sign |= 8u;
    }
    return e;
}

} // namespace

void write_surface_words(const Mesh& mesh, std::uint32_t triangle, const glm::mat4& to_frame,
                         std::uint32_t object, bool extended, std::uint32_t* words) {
    glm::uvec3 v = mesh.triangles[triangle];
    const glm::mat3 directions(to_frame);
    const bool flip = glm::determinant(directions) < 0;
    if (flip) std::swap(v.y, v.z);
    const glm::mat3 normals = glm::inverseTranspose(directions);
    SurfaceRecord record{};
    for (int k = 0; k < 3; ++k) {
        const glm::vec3 n = normals * mesh.normals[v[k]];
        record.normal[k] = octahedral_encode(std::isfinite(n.x + n.y + n.z) ? n : mesh.normals[v[k]]);
        record.uv0[k] = at_or_zero(mesh.uv0, v[k]);
    }
    record.material = mesh.triangle_materials[triangle];
    record.light = NO_LIGHT;
    record.object = object;
    std::memcpy(words, &record, sizeof(record));
    if (!extended) return;
    const SurfaceExtension e = extension_of(mesh, v, directions, flip);
    std::memcpy(words + sizeof(record) / 4, &e, sizeof(e));
}

} // namespace ajar
