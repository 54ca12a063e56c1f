#include "export/placement.hpp"

#include <cmath>
#include <glm/gtc/quaternion.hpp>

namespace ajar::gltf_out {

namespace {

// Cosine between axes up to which they count as perpendicular: products of a few rotations and scales in
// floats stay below it, and no picture shows it.
constexpr double SHEAR = 1e-5;

struct Stretch {
    glm::dmat3 rotation;
    glm::dvec3 scale;
};

// The columns' lengths, and their directions; a mirror is a negative scale.
Stretch split(const glm::dmat3& m) {
    Stretch result{m, {glm::length(m[0]), glm::length(m[1]), glm::length(m[2])}};
    if (glm::determinant(m) < 0) result.scale.x = -result.scale.x;
    for (int c = 0; c < 3; ++c) result.rotation[c] /= result.scale[c];
    return result;
}

bool shears(const glm::dmat3& rotation) {
    return std::abs(glm::dot(rotation[0], rotation[1])) > SHEAR ||
           std::abs(glm::dot(rotation[1], rotation[2])) > SHEAR ||
           std::abs(glm::dot(rotation[2], rotation[0])) > SHEAR;
}

// A rotation whose columns are the eigenvectors of a symmetric matrix (Jacobi 1846, cyclic).
glm::dmat3 eigenvectors(glm::dmat3 a) {
    glm::dmat3 v(1);
    for (int sweep = 0; sweep < 32; ++sweep)
        for (int p = 0; p < 2; ++p)
            for (int q = p + 1; q < 3; ++q) {
                if (a[q][p] == 0) continue;
                const double angle = 0.5 * std::atan2(2 * a[q][p], a[q][q] - a[p][p]);
                glm::dmat3 turn(1);
                turn[p][p] = turn[q][q] = std::cos(angle);
                turn[q][p] = std::sin(angle);
                turn[p][q] = -turn[q][p];
                a = glm::transpose(turn) * a * turn;
                v = v * turn;
            }
    return v;
}

void set_rotation(Json& node, const glm::dmat3& rotation) {
    const glm::quat q(glm::normalize(glm::quat_cast(rotation)));
    if (q != glm::quat(1, 0, 0, 0)) node["rotation"] = {q.x, q.y, q.z, q.w};
}

void set_place(Json& node, const glm::vec3& translation, const Stretch& stretch) {
    if (translation != glm::vec3(0)) node["translation"] = numbers(translation);
    set_rotation(node, stretch.rotation);
    const glm::vec3 scale(stretch.scale);
    if (scale != glm::vec3(1)) node["scale"] = numbers(scale);
}

} // namespace

void place(Document& document, Json node, const glm::mat4& to_world) {
    const glm::dmat3 m(to_world);
    const Stretch whole = split(m);
    if (!shears(whole.rotation)) {
        set_place(node, to_world[3], whole);
        document.add_root(std::move(node));
        return;
    }
    // m = U S V^T: the child turns by V^T, the parent stretches by S and turns by U.
    const glm::dmat3 v = eigenvectors(glm::transpose(m) * m);
    set_rotation(node, glm::transpose(v));
    const std::uint32_t child = document.push("nodes", std::move(node));
    Json parent;
    set_place(parent, to_world[3], split(m * v));
    parent["children"] = {child};
    document.add_root(std::move(parent));
}

} // namespace ajar::gltf_out
