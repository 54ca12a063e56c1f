// One primitive: its vertices and triangles, whatever the layout, mode and compression (glTF 2.0, section
// 3.7.2).
#pragma once

#include "import/accessors.hpp"

#include <array>

namespace ajar::gltf {

// Up to four joints of a vertex, of which a primitive may have several sets.
struct Influences {
    std::vector<glm::uvec4> joints;
    std::vector<glm::vec4> weights;
};

// Attributes are empty or have one value per position.
struct Primitive {
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;
    std::vector<glm::vec4> tangents;
    std::array<std::vector<glm::vec2>, 2> uv;
    std::vector<glm::vec4> colors;
    std::vector<Influences> influences;
    std::vector<glm::uvec3> triangles;
    std::uint64_t file_vertices = 0;      // what the file's accessors hold,
    std::vector<std::uint32_t> selection; // and which of them these are; empty: all
};

// True for points and lines, which a path tracer cannot show.
bool has_no_triangles(const JsonObject& primitive);

struct PrimitiveReader {
    Document& document;
    Buffers& buffers;
    Accessors& accessors;

    // Indices are in range, positions finite. Joints are read only where `is_skinned`.
    Primitive read(const JsonObject& primitive, bool is_skinned);
};

} // namespace ajar::gltf
