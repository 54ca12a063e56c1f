// The file itself: GLB chunks, JSON, asset, external files.
#include "base/error.hpp"
#include "base/file.hpp"
#include "support/temporary_folder.hpp"
#include "unit/import/gltf_builder.hpp"

#include <gtest/gtest.h>

namespace ajar::test {
namespace {

std::string file_error(const std::filesystem::path& path) {
    try {
        import_gltf(path);
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

std::string text_error(std::string_view text) { return import_error(std::as_bytes(std::span(text))); }

TEST(GltfFile, ReadsTheSameSceneFromGlbAndFromText) {
    const GltfBuilder b = triangle();
    const Scene from_glb = import(b).scene;
    const Scene from_text = import_text(b.text()).scene;
    ASSERT_EQ(from_glb.meshes.size(), 1u);
    EXPECT_EQ(from_glb.meshes[0].positions, from_text.meshes[0].positions);
    EXPECT_EQ(from_glb.meshes[0].positions[1], glm::vec3(1, 0, 0));
}

TEST(GltfFile, ReadsExternalFilesWithSpacesUnicodeAndParents) {
    const TemporaryFolder folder;
    GltfBuilder b = triangle();
    std::filesystem::create_directory(folder.path() / "models");
    write_file(folder.path() / "b\xc3\xbc ffer #1.bin", b.bin);
    b.json["buffers"] = {{{"byteLength", b.bin.size()}, {"uri", "../b%C3%BC%20ffer%20%231.bin"}}};
    write_file(folder.path() / "models" / "scene.gltf", b.json.dump());
    const ImportResult result = import_gltf(folder.path() / "models" / "scene.gltf");
    EXPECT_EQ(result.scene.meshes.at(0).triangles.size(), 1u);
    EXPECT_EQ(result.info.bytes_read, b.json.dump().size() + b.bin.size());
}

TEST(GltfFile, NamesAMissingFile) {
    const TemporaryFolder folder;
    GltfBuilder b = triangle();
    b.json["buffers"] = {{{"byteLength", b.bin.size()}, {"uri", "gone.bin"}}};
    write_file(folder.path() / "scene.gltf", b.json.dump());
    const std::string message = file_error(folder.path() / "scene.gltf");
    EXPECT_NE(message.find("buffers[0].uri"), std::string::npos) << message;
    EXPECT_NE(message.find("gone.bin: no such file"), std::string::npos) << message;
    EXPECT_NE(file_error(folder.path() / "none.glb").find("no such file"), std::string::npos);
}

TEST(GltfFile, RejectsAFolder) {
    const TemporaryFolder folder;
    EXPECT_NE(file_error(folder.path()).find("is a folder"), std::string::npos);
}

TEST(GltfFile, RejectsUrisThatLeadElsewhere) {
    GltfBuilder b = triangle();
    for (const char* uri : {"http://example.org/a.bin", "/dev/zero"}) {
        b.json["buffers"] = {{{"byteLength", b.bin.size()}, {"uri", uri}}};
        EXPECT_NE(import_error(b).find(uri), std::string::npos) << uri;
    }
}

TEST(GltfFile, RejectsEveryTruncationOfAGlb) {
    const std::vector<std::byte> whole = triangle().glb();
    for (std::size_t size = 0; size < whole.size(); ++size)
        EXPECT_NE(import_error(std::span(whole).first(size)), "") << size;
    EXPECT_EQ(import_error(whole), "");
}

TEST(GltfFile, RejectsOtherVersionsAndOtherFiles) {
    std::vector<std::byte> old = triangle().glb();
    old[4] = std::byte{1};
    EXPECT_NE(import_error(old).find("version 1"), std::string::npos);
    EXPECT_NE(text_error("{}").find("asset"), std::string::npos);
    EXPECT_NE(text_error(R"({"asset": {"version": "1.0"}})").find("glTF 1.0"), std::string::npos);
    EXPECT_NE(text_error(R"({"asset": {"version": "2.1", "minVersion": "2.1"}})").find("2.1"),
              std::string::npos);
    EXPECT_NE(text_error("not JSON").find("not valid JSON"), std::string::npos);
    EXPECT_NE(text_error("[]").find("must be an object"), std::string::npos);
    EXPECT_EQ(text_error(R"({"asset": {"version": "2.3"}})"), "");
}

TEST(GltfFile, RejectsJsonThatIsTooDeep) {
    const std::string deep = R"({"asset": )" + std::string(100'000, '[');
    EXPECT_NE(text_error(deep).find("nested"), std::string::npos);
}

TEST(GltfFile, AnErrorIsOneLineWhateverTheNames) {
    GltfBuilder b = triangle();
    b.json["extensionsRequired"] = {"EXT_a\nb"};
    const std::string message = import_error(b);
    EXPECT_NE(message.find("EXT_a b"), std::string::npos);
    EXPECT_EQ(message.find('\n'), std::string::npos);
}

TEST(GltfFile, NamesThePlaceAndTheTypeOfAWrongValue) {
    GltfBuilder b = triangle();
    b.json["meshes"][0]["primitives"][0]["attributes"]["POSITION"] = "zero";
    EXPECT_NE(import_error(b).find(
                  "meshes[0].primitives[0].attributes.POSITION: must be a whole number, is a string"),
              std::string::npos);
    b.json["meshes"][0]["primitives"] = nlohmann::json::object();
    EXPECT_NE(import_error(b).find("meshes[0].primitives: must be an array, is an object"),
              std::string::npos);
}

TEST(GltfFile, RejectsRangesOutsideTheBuffer) {
    GltfBuilder b = triangle();
    b.json["bufferViews"][0]["byteLength"] = 37;
    EXPECT_NE(import_error(b).find("bufferViews[0]"), std::string::npos);
    b.json["bufferViews"][0] = {
        {"buffer", 0}, {"byteOffset", 9007199254740992}, {"byteLength", 9007199254740992}};
    EXPECT_NE(import_error(b).find("bufferViews[0]"), std::string::npos);
    b = triangle();
    b.json["buffers"] = {{{"byteLength", 40}}};
    EXPECT_NE(import_error(b).find("buffers[0].byteLength"), std::string::npos);
    b.json["accessors"][0]["bufferView"] = 1;
    EXPECT_NE(import_error(b).find("buffer view 1 does not exist"), std::string::npos);
}

TEST(GltfFile, RefusesAnUnknownRequiredExtensionAndWarnsOfIgnoredOnes) {
    GltfBuilder b = triangle();
    b.json["extensionsUsed"] = {"EXT_of_nobody", "KHR_materials_unlit"};
    const ImportResult result = import(b);
    ASSERT_EQ(result.info.warnings.size(), 1u);
    EXPECT_NE(result.info.warnings[0].find("EXT_of_nobody"), std::string::npos);
    EXPECT_EQ(result.info.warnings[0].find("KHR_materials_unlit"), std::string::npos);
    b.json["extensionsRequired"] = {"EXT_of_nobody"};
    EXPECT_NE(import_error(b).find("EXT_of_nobody"), std::string::npos);
}

} // namespace
} // namespace ajar::test
