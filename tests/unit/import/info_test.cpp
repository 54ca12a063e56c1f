// What `ajar info` is told.
#include "import/info.hpp"

#include "unit/import/gltf_builder.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <set>

namespace ajar::test {
namespace {

ImportResult sample() {
    GltfBuilder b = textured_triangle({{"emissiveFactor", {1, 1, 1}}});
    b.json["asset"]["generator"] = "a\ntest";
    b.json["extensionsUsed"] = {"KHR_lights_punctual", "EXT_of_nobody"};
    b.json["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", "point"}, {"name", "bulb"}}};
    b.push(
        "nodes",
        {{"mesh", 0}, {"translation", {3, 0, 0}}, {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
    b.json["scenes"][0]["nodes"].push_back(1);
    b.push("meshes", {{"primitives", {{{"attributes", {{"POSITION", 0}}}}}}});
    return import(b);
}

TEST(Info, CountsTheFileAndTheScene) {
    const nlohmann::json info = info_json(sample());
    EXPECT_EQ(info["file"]["nodes"], 2);
    EXPECT_EQ(info["file"]["meshes"], 2);
    EXPECT_EQ(info["file"]["primitives"], 2);
    EXPECT_EQ(info["file"]["lights"], 1);
    EXPECT_EQ(info["scene"]["meshes"], 1);
    EXPECT_EQ(info["scene"]["instances"], 2);
    EXPECT_EQ(info["scene"]["triangles"], 1);
    EXPECT_EQ(info["scene"]["placed_triangles"], 2);
    EXPECT_EQ(info["scene"]["bounds"]["upper"], (nlohmann::json{4.0, 1.0, 0.0}));
    EXPECT_EQ(info["scene"]["lights"][0]["kind"], "point");
    EXPECT_EQ(info["scene"]["automatic_camera"], true);
    EXPECT_EQ(info["scene"]["has_light"], true);
    // Three vertices of position, normal and uv, one triangle of three indices and a material, and the three
    // structs.
    EXPECT_EQ(info["scene"]["memory_bytes"],
              3 * (12 + 12 + 8) + 12 + 4 + 2 * sizeof(Instance) + sizeof(Material) + sizeof(Light));
}

TEST(Info, NamesExtensionsWithTheirSupport) {
    const nlohmann::json extensions = info_json(sample())["file"]["extensions"];
    ASSERT_EQ(extensions.size(), 2u);
    EXPECT_EQ(extensions[0],
              (nlohmann::json{{"name", "EXT_of_nobody"}, {"required", false}, {"support", "ignored"}}));
    EXPECT_EQ(extensions[1]["support"], "supported");
}

TEST(Info, SaysItInLinesForPeople) {
    const std::string text = info_text(sample());
    for (const char* line : {"generator    a test\n", "extension    EXT_of_nobody (ignored)\n",
                             "light        bulb (point)\n", "bounds       (0, 0, 0) to (4, 1, 0) m\n"})
        EXPECT_NE(text.find(line), std::string::npos) << text;
    EXPECT_EQ(text.back(), '\n');
}

TEST(Info, CopesWithAnEmptyScene) {
    const ImportResult result = import_text(R"({"asset": {"version": "2.0"}})");
    EXPECT_TRUE(info_json(result)["scene"]["bounds"].is_null());
    EXPECT_NE(info_text(result).find("light        none"), std::string::npos);
}

TEST(Info, ListsKnownExtensionsOnceInOrder) {
    const std::vector<KnownExtension> known = known_extensions();
    std::vector<std::string_view> names;
    for (const KnownExtension& extension : known) {
        names.push_back(extension.name);
        EXPECT_FALSE(extension.help.empty());
        EXPECT_NE(extension.support, ExtensionSupport::ignored);
    }
    EXPECT_TRUE(std::is_sorted(names.begin(), names.end()));
    EXPECT_EQ(std::set(names.begin(), names.end()).size(), names.size());
}

} // namespace
} // namespace ajar::test
