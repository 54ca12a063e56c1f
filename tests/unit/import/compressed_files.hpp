// Files compressed by the encoders of meshoptimizer and Draco, for the tests of their decoding.
#pragma once

#include "unit/import/gltf_builder.hpp"

#include <meshoptimizer.h>

namespace ajar::test {

inline const std::vector<glm::vec3> SQUARE{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
inline const std::vector<std::uint32_t> SQUARE_INDICES{0, 1, 2, 2, 1, 3};

// A buffer view that says: this is what the compressed bytes hold. To be the last one added to the buffer.
unsigned compressed_view(GltfBuilder& b, const std::vector<unsigned char>& bytes, std::size_t count,
                         std::size_t stride, const char* mode, const char* filter = "NONE",
                         const char* name = "EXT_meshopt_compression");

template <class T> std::vector<unsigned char> encode_vertices(const std::vector<T>& vertices) {
    std::vector<unsigned char> bytes(meshopt_encodeVertexBufferBound(vertices.size(), sizeof(T)));
    bytes.resize(
        meshopt_encodeVertexBuffer(bytes.data(), bytes.size(), vertices.data(), vertices.size(), sizeof(T)));
    return bytes;
}

// The square as a Draco stream with attributes 0 (positions) and 1 (normals), and a file whose mesh is that
// stream.
std::vector<char> draco_square();
GltfBuilder draco_file(const std::vector<char>& stream);

} // namespace ajar::test
