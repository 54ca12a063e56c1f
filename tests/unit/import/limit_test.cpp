// Small files that ask for much: each must end in an Error, at once and without taking the memory.
#include "unit/image/png_maker.hpp"
#include "unit/import/gltf_builder.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>

namespace ajar::test {
namespace {

// The most memory the process has ever held, MiB.
long peak_memory() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss / 1024;
}

ImportOptions strict() {
    ImportOptions options;
    options.limits.decoded_slack_bytes = std::uint64_t{16} << 20;
    options.limits.decoded_ratio = 64;
    return options;
}

TEST(GltfLimits, HoldForAPrimitiveRepeatedManyTimes) {
    GltfBuilder b;
    const unsigned position = b.add(std::vector<glm::vec3>(30'000));
    nlohmann::json primitives = nlohmann::json::array();
    for (int i = 0; i < 2000; ++i) primitives.push_back({{"attributes", {{"POSITION", position}}}});
    b.show(primitives[0]);
    b.json["meshes"][0]["primitives"] = primitives;
    const long before = peak_memory();
    EXPECT_NE(import_error(b, strict()).find("the limit is"), std::string::npos);
    EXPECT_LT(peak_memory() - before, 400);
}

TEST(GltfLimits, HoldForManyShapesOfOneMesh) {
    GltfBuilder b;
    const unsigned position = b.add(std::vector<glm::vec3>(30'000));
    b.show({{"attributes", {{"POSITION", position}}}, {"targets", {{{"POSITION", position}}}}});
    for (int i = 0; i < 2000; ++i) {
        b.push("nodes", {{"mesh", 0}, {"weights", {0.001 * i}}});
        b.json["scenes"][0]["nodes"].push_back(i + 1);
    }
    EXPECT_NE(import_error(b, strict()).find("the limit is"), std::string::npos);
}

TEST(GltfLimits, HoldForMorphTargetsRepeatedManyTimes) {
    GltfBuilder b;
    const unsigned position = b.add(std::vector<glm::vec3>(30'000));
    b.show({{"attributes", {{"POSITION", position}}}});
    b.json["meshes"][0]["primitives"][0]["targets"] =
        std::vector<nlohmann::json>(5000, {{"POSITION", position}});
    b.json["meshes"][0]["weights"] = std::vector<float>(5000, 1.0f);
    EXPECT_NE(import_error(b, strict()).find("the limit is"), std::string::npos);
}

TEST(GltfLimits, HoldForTheNumberOfTriangles) {
    ImportOptions options;
    options.limits.max_triangles = 9'999;
    GltfBuilder b;
    b.show({{"attributes", {{"POSITION", b.add(std::vector<glm::vec3>(30'000))}}}});
    EXPECT_NE(import_error(b, options).find("past 9999 triangles"), std::string::npos);
    options.limits.max_triangles = 10'000;
    EXPECT_EQ(import_error(b, options), "");
}

TEST(GltfLimits, HoldForTheNumberOfNodes) {
    ImportOptions options;
    options.limits.max_nodes = 2;
    GltfBuilder b = triangle();
    b.json["nodes"] = {{{"mesh", 0}}, {{"mesh", 0}}, {{"mesh", 0}}};
    EXPECT_NE(import_error(b, options).find("nodes: there are 3"), std::string::npos);
}

TEST(GltfLimits, HoldForTheNumberOfJsonValues) {
    std::string text = R"({"asset": {"version": "2.0"}, "extras": [)";
    for (int i = 0; i < 6'000'001; ++i) text += "0,";
    text += "0]}";
    EXPECT_NE(import_error(std::as_bytes(std::span(text))).find("values"), std::string::npos);
}

TEST(GltfLimits, RefuseImagesOfNoSizeAndOfBombSize) {
    for (const auto& [width, height] : {std::pair<std::uint32_t, std::uint32_t>{0, 1},
                                        {1, 0},
                                        {60'000, 60'000},
                                        {0x7fffffff, 0x7fffffff},
                                        {0xffffffff, 2}}) {
        GltfBuilder b = textured_triangle({{"emissiveTexture", {{"index", 0}}}});
        const std::vector<std::byte> image = make_png({.width = width, .height = height});
        b.push("images", {{"bufferView", b.view(image)}});
        b.push("textures", {{"source", 0}});
        const long before = peak_memory();
        const std::string message = import_error(b);
        EXPECT_NE(message.find("images[0]"), std::string::npos) << message;
        EXPECT_EQ(message.find('\n'), std::string::npos);
        EXPECT_LT(peak_memory() - before, 100);
    }
}

} // namespace
} // namespace ajar::test
