// The combinatorial half of MikkTSpace: which corners of which triangles share one tangent frame.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace ajar::gltf {

inline constexpr std::uint32_t NONE = 0xffffffffu;

// A triangle of welded vertices and the directions in which its texture coordinates grow.
struct TangentTriangle {
    std::array<std::uint32_t, 3> vertices{};
    glm::vec3 ds{0};            // along increasing s (u), unit unless the triangle is flat in texture space
    glm::vec3 dt{0};            // along increasing t (v)
    bool preserves = false;     // the texture is not mirrored
    bool joins_any = true;      // has no direction of its own, so it goes with any neighbour
    bool is_degenerate = false; // two corners at one place: takes part in nothing
    std::array<std::uint32_t, 3> neighbours{NONE, NONE,
                                            NONE};         // across the edge from corner i to corner i + 1
    std::array<std::uint32_t, 3> groups{NONE, NONE, NONE}; // of each corner

    std::uint32_t corner(std::uint32_t vertex) const {
        return vertices[0] == vertex ? 0 : vertices[1] == vertex ? 1 : 2;
    }
};

// The triangles around a vertex that are connected by edges and have the same handedness.
struct TangentGroup {
    std::uint32_t vertex = 0;
    bool preserves = false;
    std::vector<std::uint32_t> triangles;
};

// Gives vertices with equal position, normal and texture coordinate one index: the smallest of theirs.
std::vector<std::uint32_t> weld(std::span<const glm::vec3> positions, std::span<const glm::vec3> normals,
                                std::span<const glm::vec2> uv);

// Sets `neighbours`: triangles that run along an edge in opposite directions, pair by pair in order.
void connect(std::vector<TangentTriangle>& triangles);

// Sets `groups`, and the handedness of triangles that join any.
std::vector<TangentGroup> make_groups(std::vector<TangentTriangle>& triangles);

} // namespace ajar::gltf
