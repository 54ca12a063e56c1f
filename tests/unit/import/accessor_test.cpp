// Accessors: what the specification says a stored number means, seen through positions, colours and texture
// coordinates.
#include "unit/import/gltf_builder.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace ajar::test {
namespace {

// A triangle whose COLOR_0 is the given accessor.
GltfBuilder with_colors(GltfBuilder b, unsigned accessor) {
    b.json["meshes"][0]["primitives"][0]["attributes"]["COLOR_0"] = accessor;
    return b;
}

template <class T> float first_red(Component component, bool normalized, T value) {
    GltfBuilder b = triangle();
    const unsigned view = b.view(std::vector<T>(12, value));
    const unsigned colors = b.accessor(view, component, 3, "VEC4", normalized);
    return import(with_colors(b, colors)).scene.meshes[0].colors[0].r;
}

TEST(GltfAccessor, NormalisesEveryIntegerType) { // glTF 2.0, section 3.6.2.2
    EXPECT_EQ(first_red<std::uint8_t>(U8, true, 255), 1.0f);
    EXPECT_EQ(first_red<std::uint8_t>(U8, true, 51), 51.0f / 255);
    EXPECT_EQ(first_red<std::uint16_t>(U16, true, 65535), 1.0f);
    EXPECT_EQ(first_red<std::int8_t>(I8, true, 127), 1.0f);
    EXPECT_EQ(first_red<std::int8_t>(I8, true, -128), -1.0f);
    EXPECT_EQ(first_red<std::int16_t>(I16, true, -32768), -1.0f);
    EXPECT_EQ(first_red<std::int16_t>(I16, true, 16384), 16384.0f / 32767);
}

TEST(GltfAccessor, KeepsIntegersThatAreNotNormalised) {
    EXPECT_EQ(first_red<std::uint8_t>(U8, false, 7), 7.0f);
    EXPECT_EQ(first_red<std::int16_t>(I16, false, -300), -300.0f);
    EXPECT_EQ(first_red<float>(F32, false, 0.25f), 0.25f);
}

TEST(GltfAccessor, GivesColoursOfThreeComponentsAnAlphaOfOne) {
    GltfBuilder b = triangle();
    const unsigned colors = b.add(std::vector<glm::vec3>(3, {0.25f, 0.5f, 0.75f}));
    EXPECT_EQ(import(with_colors(b, colors)).scene.meshes[0].colors[2], glm::vec4(0.25f, 0.5f, 0.75f, 1));
}

TEST(GltfAccessor, ReadsInterleavedAttributes) {
    GltfBuilder b;
    struct Vertex {
        glm::vec3 position, normal;
        glm::vec2 uv;
    };
    const unsigned view = b.view(std::vector<Vertex>{{{0, 0, 0}, {0, 0, 1}, {0.1f, 0.2f}},
                                                     {{1, 0, 0}, {0, 0, 1}, {0.3f, 0.4f}},
                                                     {{0, 1, 0}, {0, 0, 1}, {0.5f, 0.6f}}},
                                 sizeof(Vertex));
    const unsigned position = b.accessor(view, F32, 3, "VEC3");
    const unsigned normal = b.accessor(view, F32, 3, "VEC3", false, 12);
    const unsigned uv = b.accessor(view, F32, 3, "VEC2", false, 24);
    b.show({{"attributes", {{"POSITION", position}, {"NORMAL", normal}, {"TEXCOORD_0", uv}}}});
    const Mesh mesh = import(b).scene.meshes.at(0);
    EXPECT_EQ(mesh.positions[2], glm::vec3(0, 1, 0));
    EXPECT_EQ(mesh.normals[1], glm::vec3(0, 0, 1));
    EXPECT_EQ(mesh.uv0[2], glm::vec2(0.5f, 0.6f));
}

TEST(GltfAccessor, ReadsQuantisedPositionsWithPadding) { // KHR_mesh_quantization: 6 bytes in a stride of 8
    GltfBuilder b;
    const unsigned view = b.view(std::vector<std::uint16_t>{0, 0, 0, 9, 65535, 0, 0, 9, 0, 65535, 0, 9}, 8);
    b.show({{"attributes", {{"POSITION", b.accessor(view, U16, 3, "VEC3", true)}}}});
    b.json["extensionsRequired"] = {"KHR_mesh_quantization"};
    const Mesh mesh = import(b).scene.meshes.at(0);
    EXPECT_EQ(mesh.positions[1], glm::vec3(1, 0, 0));
    EXPECT_EQ(mesh.positions[2], glm::vec3(0, 1, 0));
}

nlohmann::json sparse(GltfBuilder& b, const std::vector<std::uint16_t>& indices,
                      const std::vector<glm::vec3>& values) {
    const unsigned index_view = b.view(indices);
    const unsigned value_view = b.view(values);
    return {{"count", indices.size()},
            {"indices", {{"bufferView", index_view}, {"componentType", U16}}},
            {"values", {{"bufferView", value_view}}}};
}

TEST(GltfAccessor, SubstitutesSparseElements) {
    GltfBuilder b = triangle();
    b.json["accessors"][0]["sparse"] = sparse(b, {1}, {{5, 0, 0}});
    const Mesh mesh = import(b).scene.meshes.at(0);
    EXPECT_EQ(mesh.positions[1], glm::vec3(5, 0, 0));
    EXPECT_EQ(mesh.positions[2], glm::vec3(0, 1, 0));
}

TEST(GltfAccessor, SubstitutesInZerosWithoutABufferView) {
    GltfBuilder b = triangle();
    b.json["accessors"][0]["sparse"] = sparse(b, {1, 2}, {{5, 0, 0}, {0, 6, 0}});
    b.json["accessors"][0].erase("bufferView");
    const Mesh mesh = import(b).scene.meshes.at(0);
    EXPECT_EQ(mesh.positions[0], glm::vec3(0));
    EXPECT_EQ(mesh.positions[2], glm::vec3(0, 6, 0));
}

TEST(GltfAccessor, RejectsSparseIndicesOutOfRange) {
    GltfBuilder b = triangle();
    b.json["accessors"][0]["sparse"] = sparse(b, {3}, {{5, 0, 0}});
    EXPECT_NE(import_error(b).find("sparse.indices: index 3 is out of range"), std::string::npos)
        << import_error(b);
    b.json["accessors"][0]["sparse"]["count"] = 4;
    EXPECT_NE(import_error(b).find("sparse.count"), std::string::npos);
}

TEST(GltfAccessor, RejectsHugeCountsBeforeAllocating) {
    for (const std::uint64_t count : {std::uint64_t{4}, std::uint64_t{4'000'000'000}, std::uint64_t{1} << 40,
                                      std::numeric_limits<std::uint64_t>::max()}) {
        GltfBuilder b = triangle();
        b.json["accessors"][0]["count"] = count;
        EXPECT_NE(import_error(b), "") << count;
    }
    GltfBuilder b = triangle();
    b.json["accessors"][0]["count"] = 400'000'000; // which nothing in the file bounds without a buffer view
    b.json["accessors"][0].erase("bufferView");
    EXPECT_NE(import_error(b).find("the limit is"), std::string::npos) << import_error(b);
}

TEST(GltfAccessor, RejectsElementsThatDoNotFitTheirStride) {
    GltfBuilder b = triangle();
    b.json["bufferViews"][0]["byteStride"] = 8;
    EXPECT_NE(import_error(b).find("byteStride of 8"), std::string::npos);
    b.json["bufferViews"][0]["byteStride"] = 6;
    EXPECT_NE(import_error(b).find("byteStride"), std::string::npos);
}

TEST(GltfAccessor, RejectsUnknownTypesAndWrongOnes) {
    for (const auto& [key, value] : {std::pair<const char*, nlohmann::json>{"componentType", 5124},
                                     {"componentType", 1},
                                     {"type", "VEC9"},
                                     {"type", "VEC2"},
                                     {"type", 3}}) {
        GltfBuilder b = triangle();
        b.json["accessors"][0][key] = value;
        EXPECT_NE(import_error(b).find("accessors[0]"), std::string::npos) << key << value;
    }
}

} // namespace
} // namespace ajar::test
