#include "import/normals.hpp"

#include <cmath>

namespace ajar::gltf {

namespace {

// Twice the area times the unit normal. In double: the product of two edges overflows and underflows a float.
glm::dvec3 face_normal(const Primitive& primitive, const glm::uvec3& t) {
    const glm::dvec3 a(primitive.positions[t.x]);
    return glm::cross(glm::dvec3(primitive.positions[t.y]) - a, glm::dvec3(primitive.positions[t.z]) - a);
}

// Any unit vector will do for a face without area: no ray meets it.
glm::vec3 unit(const glm::dvec3& v) {
    const double length = glm::length(v);
    return length > 0 ? glm::vec3(v / length) : glm::vec3(0, 0, 1);
}

template <class T> void unweld(std::vector<T>& values, const std::vector<glm::uvec3>& triangles) {
    if (values.empty()) return;
    std::vector<T> result;
    result.reserve(triangles.size() * 3);
    for (const glm::uvec3& t : triangles)
        for (int k = 0; k < 3; ++k) result.push_back(values[t[k]]);
    values = std::move(result);
}

// What is of unit length as floats have it keeps its bits, so that a file comes back as it was written.
bool is_unit(double length) { return std::abs(length - 1) <= 0x1p-22; }

} // namespace

void make_flat_normals(Primitive& primitive) {
    std::vector<glm::vec3> normals;
    normals.reserve(primitive.triangles.size() * 3);
    for (const glm::uvec3& t : primitive.triangles)
        normals.insert(normals.end(), 3, unit(face_normal(primitive, t)));
    primitive.normals = std::move(normals);
    unweld(primitive.positions, primitive.triangles);
    unweld(primitive.uv[0], primitive.triangles);
    unweld(primitive.uv[1], primitive.triangles);
    unweld(primitive.colors, primitive.triangles);
    for (std::uint32_t i = 0; i < primitive.triangles.size(); ++i)
        primitive.triangles[i] = glm::uvec3(3 * i, 3 * i + 1, 3 * i + 2);
}

void repair_normals(Primitive& primitive) {
    std::vector<glm::dvec3> means;
    for (std::size_t i = 0; i < primitive.normals.size(); ++i) {
        const glm::dvec3 n(primitive.normals[i]);
        const double length = glm::length(n);
        if (is_unit(length)) continue;
        if (length > 0 && std::isfinite(length)) {
            primitive.normals[i] = glm::vec3(n / length);
            continue;
        }
        if (means.empty()) {
            means.resize(primitive.positions.size());
            for (const glm::uvec3& t : primitive.triangles)
                for (int k = 0; k < 3; ++k) means[t[k]] += face_normal(primitive, t);
        }
        primitive.normals[i] = unit(means[i]);
    }
}

} // namespace ajar::gltf
