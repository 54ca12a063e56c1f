// meshopt and Draco: what their own encoders write is read back; what they would not survive is refused.
#include "unit/import/compressed_files.hpp"

#include <gtest/gtest.h>
#include <meshoptimizer.h>

namespace ajar::test {
namespace {

GltfBuilder square_with_indices(const std::vector<unsigned char>& bytes, const char* mode) {
    GltfBuilder b;
    const unsigned position = b.add(SQUARE);
    const unsigned normal = b.add(std::vector<glm::vec3>(4, {0, 0, 1}));
    const unsigned view = compressed_view(b, bytes, 6, 2, mode);
    b.show({{"attributes", {{"POSITION", position}, {"NORMAL", normal}}},
            {"indices", b.accessor(view, U16, 6, "SCALAR")}});
    return b;
}

TEST(Meshopt, DecodesAttributes) {
    for (const char* name : {"EXT_meshopt_compression", "KHR_meshopt_compression"}) {
        GltfBuilder b;
        const unsigned view = compressed_view(b, encode_vertices(SQUARE), 4, 12, "ATTRIBUTES", "NONE", name);
        const unsigned position = b.accessor(view, F32, 4, "VEC3");
        b.show({{"attributes", {{"POSITION", position}}}, {"mode", 5}});
        b.json["extensionsRequired"] = {name};
        const Mesh mesh = import(b).scene.meshes.at(0);
        ASSERT_EQ(mesh.triangles.size(), 2u) << name;
        EXPECT_EQ(mesh.positions[mesh.triangles[1][1]], glm::vec3(1, 1, 0));
    }
}

TEST(Meshopt, DecodesTriangles) {
    std::vector<unsigned char> bytes(meshopt_encodeIndexBufferBound(6, 4));
    bytes.resize(meshopt_encodeIndexBuffer(bytes.data(), bytes.size(), SQUARE_INDICES.data(), 6));
    const Mesh mesh = import(square_with_indices(bytes, "TRIANGLES")).scene.meshes.at(0);
    ASSERT_EQ(mesh.triangles.size(), 2u);
    glm::vec3 area(0); // the codec may turn a triangle, which does not change this
    for (const glm::uvec3& t : mesh.triangles)
        area += 0.5f * glm::cross(mesh.positions[t.y] - mesh.positions[t.x],
                                  mesh.positions[t.z] - mesh.positions[t.x]);
    EXPECT_EQ(area, glm::vec3(0, 0, 1));
}

TEST(Meshopt, DecodesIndexSequences) {
    std::vector<unsigned char> bytes(meshopt_encodeIndexSequenceBound(6, 4));
    bytes.resize(meshopt_encodeIndexSequence(bytes.data(), bytes.size(), SQUARE_INDICES.data(), 6));
    const Mesh mesh = import(square_with_indices(bytes, "INDICES")).scene.meshes.at(0);
    EXPECT_EQ(mesh.triangles, (std::vector<glm::uvec3>{{0, 1, 2}, {2, 1, 3}}));
}

TEST(Meshopt, DecodesOctahedralNormals) {
    const std::vector<glm::vec4> normals{{0, 0, 1, 0}, {1, 0, 0, 0}, {0, -1, 0, 0}, {0.6f, 0, -0.8f, 0}};
    std::vector<glm::i8vec4> filtered(4);
    meshopt_encodeFilterOct(filtered.data(), 4, 4, 8, &normals[0].x);
    GltfBuilder b;
    const unsigned position = b.add(SQUARE);
    const unsigned view = compressed_view(b, encode_vertices(filtered), 4, 4, "ATTRIBUTES", "OCTAHEDRAL");
    const unsigned normal = b.accessor(view, I8, 4, "VEC3", true);
    b.show({{"attributes", {{"POSITION", position}, {"NORMAL", normal}}}, {"mode", 5}});
    const Mesh mesh = import(b).scene.meshes.at(0);
    for (std::size_t i = 0; i < 4; ++i)
        EXPECT_NEAR(glm::length(mesh.normals[i] - glm::vec3(normals[i])), 0, 0.03f) << i; // eight bits
}

TEST(Meshopt, DecodesExponentialPositions) {
    std::vector<glm::vec3> filtered(4);
    meshopt_encodeFilterExp(filtered.data(), 4, 12, 15, &SQUARE[0].x);
    GltfBuilder b;
    const unsigned view = compressed_view(b, encode_vertices(filtered), 4, 12, "ATTRIBUTES", "EXPONENTIAL");
    const unsigned position = b.accessor(view, F32, 4, "VEC3");
    const unsigned normal = b.add(std::vector<glm::vec3>(4, {0, 0, 1}));
    b.show({{"attributes", {{"POSITION", position}, {"NORMAL", normal}}}, {"mode", 5}});
    b.json["buffers"][0]["byteLength"] = b.bin.size();
    const Mesh mesh = import(b).scene.meshes.at(0);
    for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(glm::length(mesh.positions[i] - SQUARE[i]), 0, 1e-4f);
}

TEST(Meshopt, RefusesStreamsOfANewerVersion) {
    std::vector<unsigned char> bytes = encode_vertices(SQUARE);
    bytes[0] = 0xa1;
    GltfBuilder b;
    const unsigned view = compressed_view(b, bytes, 4, 12, "ATTRIBUTES", "NONE", "KHR_meshopt_compression");
    b.show({{"attributes", {{"POSITION", b.accessor(view, F32, 4, "VEC3")}}}});
    EXPECT_NE(import_error(b).find("version 1"), std::string::npos) << import_error(b);
}

TEST(Meshopt, RejectsDamagedStreamsAndImpossibleSizes) {
    GltfBuilder b;
    const unsigned view = compressed_view(b, encode_vertices(SQUARE), 4, 12, "ATTRIBUTES");
    b.show({{"attributes", {{"POSITION", b.accessor(view, F32, 4, "VEC3")}}}});
    const nlohmann::json good = b.json;
    for (const auto& [key, value] : {std::pair<const char*, nlohmann::json>{"byteStride", 13},
                                     {"byteStride", 0},
                                     {"byteStride", 260},
                                     {"count", 1u << 30},
                                     {"count", std::uint64_t{1} << 60},
                                     {"mode", "TRIANGLES"},
                                     {"mode", "INDICES"},
                                     {"mode", "LINES"},
                                     {"filter", "COLOR"},
                                     {"filter", "QUATERNION"},
                                     {"byteLength", 5},
                                     {"byteLength", 0},
                                     {"buffer", 2}}) {
        b.json = good;
        b.json["bufferViews"][0]["extensions"]["EXT_meshopt_compression"][key] = value;
        EXPECT_NE(import_error(b).find("bufferViews[0]"), std::string::npos)
            << key << value << import_error(b);
    }
    b.json = good;
    EXPECT_EQ(import_error(b), "");
}

TEST(Draco, DecodesAPrimitive) {
    const Mesh mesh = import(draco_file(draco_square())).scene.meshes.at(0);
    ASSERT_EQ(mesh.positions.size(), 4u);
    ASSERT_EQ(mesh.triangles.size(), 2u);
    glm::vec3 area(0);
    for (const glm::uvec3& t : mesh.triangles)
        area += 0.5f * glm::cross(mesh.positions[t.y] - mesh.positions[t.x],
                                  mesh.positions[t.z] - mesh.positions[t.x]);
    EXPECT_NEAR(glm::length(area - glm::vec3(0, 0, 1)), 0, 1e-5f);
    EXPECT_NEAR(glm::length(mesh.normals[0] - glm::vec3(0, 0, 1)), 0, 0.01f); // quantised
}

TEST(Draco, RejectsDamagedDataAndMissingAttributes) {
    const std::vector<char> stream = draco_square();
    for (std::size_t size = 0; size < stream.size(); ++size)
        EXPECT_NE(
            import_error(draco_file({stream.begin(), stream.begin() + static_cast<std::ptrdiff_t>(size)})),
            "");
    GltfBuilder b = draco_file(stream);
    auto& extension = b.json["meshes"][0]["primitives"][0]["extensions"]["KHR_draco_mesh_compression"];
    extension["attributes"]["NORMAL"] = 9;
    EXPECT_NE(import_error(b).find("no attribute 9"), std::string::npos);
    extension["attributes"]["NORMAL"] = 1;
    extension["bufferView"] = 5;
    EXPECT_NE(import_error(b).find("buffer view 5 does not exist"), std::string::npos);
}

} // namespace
} // namespace ajar::test
