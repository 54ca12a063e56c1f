#include "import/tangents.hpp"

#include "import/tangent_groups.hpp"

#include <algorithm>
#include <cfloat>
#include <cmath>

namespace ajar::gltf {

namespace {

// Beyond this, a group is averaged as a whole: comparing all pairs of a fan of a million triangles would take
// for ever.
constexpr std::size_t MAX_COMPARED = 64;
// How many versions of a vertex are searched for an equal tangent before it is simply split again.
constexpr int MAX_SEARCHED = 32;

bool is_zero(float x) { return !(std::abs(x) > FLT_MIN); }

glm::vec3 unit_or_zero(const glm::vec3& v) {
    const float length = glm::length(v);
    return is_zero(length) ? v : v / length;
}

glm::vec3 project(const glm::vec3& v, const glm::vec3& n) { return unit_or_zero(v - n * glm::dot(n, v)); }

std::vector<glm::vec2> transformed_uv(const TextureUse& use, const Primitive& primitive) {
    std::vector<glm::vec2> uv = primitive.uv[use.uv_set];
    uv.resize(primitive.positions.size(), glm::vec2(0));
    for (glm::vec2& p : uv)
        p = {glm::dot(use.uv_row_u, glm::vec3(p, 1)), glm::dot(use.uv_row_v, glm::vec3(p, 1))};
    return uv;
}

// Mikkelsen 2008, equations 2.10 to 2.15: the derivatives of the position with respect to s and t.
TangentTriangle derivatives(const std::array<glm::vec3, 3>& p, const std::array<glm::vec2, 3>& uv) {
    TangentTriangle result;
    result.is_degenerate = p[0] == p[1] || p[1] == p[2] || p[2] == p[0];
    const glm::vec3 d1 = p[1] - p[0], d2 = p[2] - p[0];
    const glm::vec2 t1 = uv[1] - uv[0], t2 = uv[2] - uv[0];
    const float area = t1.x * t2.y - t1.y * t2.x; // twice the signed area in texture space
    result.ds = t2.y * d1 - t1.y * d2;
    result.dt = -t2.x * d1 + t1.x * d2;
    result.preserves = area > 0;
    if (is_zero(area)) return result;
    const float sign = result.preserves ? 1.0f : -1.0f;
    const float length_s = glm::length(result.ds), length_t = glm::length(result.dt);
    if (!is_zero(length_s)) result.ds *= sign / length_s;
    if (!is_zero(length_t)) result.dt *= sign / length_t;
    result.joins_any = is_zero(length_s / std::abs(area)) || is_zero(length_t / std::abs(area));
    return result;
}

// What a triangle contributes to the frame at a corner: its directions in the tangent plane, weighted by its
// angle.
struct Share {
    glm::vec3 ds, dt;
    float angle;
    bool joins_any;
};

Share share(const TangentTriangle& triangle, std::uint32_t vertex, const Primitive& primitive) {
    const glm::vec3& n = primitive.normals[vertex];
    const std::uint32_t k = triangle.corner(vertex);
    const auto at = [&](std::uint32_t corner) { return primitive.positions[triangle.vertices[corner % 3]]; };
    const glm::vec3 before = project(at(k + 2) - at(k), n), after = project(at(k + 1) - at(k), n);
    const float angle = std::acos(std::clamp(glm::dot(before, after), -1.0f, 1.0f));
    return {project(triangle.ds, n), project(triangle.dt, n), angle, triangle.joins_any};
}

// Triangles whose directions are exactly opposed are not averaged (an angular threshold of 180 degrees).
bool are_compatible(const Share& a, const Share& b) {
    return a.joins_any || b.joins_any || (glm::dot(a.ds, b.ds) > -1 && glm::dot(a.dt, b.dt) > -1);
}

// The tangent at each triangle of a group, in the order of the group.
std::vector<glm::vec3> group_tangents(const std::vector<Share>& shares) {
    const auto mean = [&](const auto& is_member) {
        glm::vec3 sum(0);
        for (std::size_t i = 0; i < shares.size(); ++i)
            if (!shares[i].joins_any && is_member(i)) sum += shares[i].angle * shares[i].ds;
        return unit_or_zero(sum);
    };
    bool is_uniform = true;
    if (shares.size() <= MAX_COMPARED)
        for (std::size_t i = 0; i < shares.size(); ++i)
            for (std::size_t j = 0; j < i; ++j)
                is_uniform = is_uniform && are_compatible(shares[i], shares[j]);
    if (is_uniform) return std::vector(shares.size(), mean([](std::size_t) { return true; }));
    std::vector<glm::vec3> tangents;
    for (std::size_t i = 0; i < shares.size(); ++i)
        tangents.push_back(
            mean([&](std::size_t j) { return i == j || are_compatible(shares[i], shares[j]); }));
    return tangents;
}

// One tangent per corner of each triangle.
std::vector<glm::vec4> corner_tangents(const Primitive& primitive, std::vector<TangentTriangle>& triangles) {
    std::vector<glm::vec4> corners(triangles.size() * 3);
    std::vector<bool> is_set(corners.size());
    std::vector<std::uint32_t> first(primitive.positions.size(), NONE); // a good corner of each welded vertex
    for (const TangentGroup& group : make_groups(triangles)) {
        std::vector<Share> shares;
        for (const std::uint32_t t : group.triangles)
            shares.push_back(share(triangles[t], group.vertex, primitive));
        const std::vector<glm::vec3> tangents = group_tangents(shares);
        for (std::size_t i = 0; i < shares.size(); ++i) {
            const std::uint32_t corner =
                3 * group.triangles[i] + triangles[group.triangles[i]].corner(group.vertex);
            // glTF's textures have v downwards and normal maps have Y upwards, which mirrors the frame.
            corners[corner] = glm::vec4(tangents[i], group.preserves ? -1.0f : 1.0f);
            is_set[corner] = true;
            first[group.vertex] = std::min(first[group.vertex], corner);
        }
    }
    // Degenerate triangles take what a good one has at the same vertex.
    for (std::uint32_t t = 0; t < triangles.size(); ++t)
        for (std::uint32_t k = 0; k < 3 && triangles[t].is_degenerate; ++k)
            if (const std::uint32_t from = first[triangles[t].vertices[k]]; from != NONE)
                corners[3 * t + k] = corners[from];
    for (std::uint32_t c = 0; c < corners.size(); ++c) {
        const glm::vec3 tangent(corners[c]);
        const glm::vec3& n = primitive.normals[triangles[c / 3].vertices[c % 3]];
        // Set, finite, and no rounding error of a direction along the normal, blown up to unit length.
        if (std::abs(glm::dot(tangent, tangent) - 1) < 1e-3f && std::abs(glm::dot(tangent, n)) < 1e-3f)
            continue;
        corners[c] = glm::vec4(perpendicular(n), is_set[c] ? corners[c].w : 1.0f);
    }
    return corners;
}

template <class T> void repeat(std::vector<T>& values, std::uint32_t index) {
    if (values.empty()) return;
    const T value = values[index]; // a copy, as push_back may move the vector
    values.push_back(value);
}

// Gives each vertex the tangent of its corners, and a copy of the vertex to corners with another tangent.
void assign(const std::vector<glm::vec4>& corners, Primitive& primitive) {
    const std::size_t count = primitive.positions.size();
    primitive.tangents.assign(count, glm::vec4(0));
    std::vector<std::uint32_t> next(count, NONE); // a vertex's next version
    for (std::uint32_t c = 0; c < corners.size(); ++c) {
        std::uint32_t& vertex = primitive.triangles[c / 3][static_cast<int>(c % 3)];
        std::uint32_t v = vertex;
        if (primitive.tangents[v].w == 0) primitive.tangents[v] = corners[c];
        for (int i = 0; i < MAX_SEARCHED && primitive.tangents[v] != corners[c] && next[v] != NONE; ++i)
            v = next[v];
        if (primitive.tangents[v] != corners[c]) {
            repeat(primitive.positions, vertex);
            repeat(primitive.normals, vertex);
            repeat(primitive.uv[0], vertex);
            repeat(primitive.uv[1], vertex);
            repeat(primitive.colors, vertex);
            primitive.tangents.push_back(corners[c]);
            next.push_back(next[v]);
            v = next[v] = static_cast<std::uint32_t>(primitive.tangents.size() - 1);
        }
        vertex = v;
    }
    for (std::size_t v = 0; v < count; ++v) // vertices of no triangle
        if (primitive.tangents[v].w == 0)
            primitive.tangents[v] = glm::vec4(perpendicular(primitive.normals[v]), 1);
}

} // namespace

glm::vec3 perpendicular(const glm::vec3& n) {
    const glm::vec3 axis = std::abs(n.x) < 0.7f ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0);
    return glm::normalize(axis - n * glm::dot(n, axis));
}

void make_tangents(const TextureUse& normal_map, Primitive& primitive) {
    const std::vector<glm::vec2> uv = transformed_uv(normal_map, primitive);
    const std::vector<std::uint32_t> welded = weld(primitive.positions, primitive.normals, uv);
    std::vector<TangentTriangle> triangles;
    triangles.reserve(primitive.triangles.size());
    for (const glm::uvec3& t : primitive.triangles) {
        triangles.push_back(
            derivatives({primitive.positions[t.x], primitive.positions[t.y], primitive.positions[t.z]},
                        {uv[t.x], uv[t.y], uv[t.z]}));
        triangles.back().vertices = {welded[t.x], welded[t.y], welded[t.z]};
    }
    connect(triangles);
    assign(corner_tangents(primitive, triangles), primitive);
}

void repair_tangents(Primitive& primitive) {
    for (std::size_t i = 0; i < primitive.tangents.size(); ++i) {
        glm::vec4& tangent = primitive.tangents[i];
        const float length = glm::length(glm::vec3(tangent));
        const bool is_usable = length > 0 && std::isfinite(length);
        const bool is_unit = std::abs(length - 1) <= 0x1p-22f; // keeps its bits
        const glm::vec3 unit = is_unit     ? glm::vec3(tangent)
                               : is_usable ? glm::vec3(tangent) / length
                                           : perpendicular(primitive.normals[i]);
        tangent = glm::vec4(unit, tangent.w < 0 ? -1.0f : 1.0f);
    }
}

} // namespace ajar::gltf
