// ajar info and ajar devices.
#include "cli/run_ajar.hpp"
#include "support/temporary_folder.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace ajar::test {

namespace {

using Json = nlohmann::json;

} // namespace

TEST(Info, TellsWhatIsInAFile) {
    const Result result = run_ajar({"info", scene_path("textured")});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    for (const char* part : {"triangles", "materials", "textures", "camera", "bounds", "memory"})
        EXPECT_NE(result.out.find(part), std::string::npos) << part;
}

TEST(Info, IsOneJsonDocumentForMachines) {
    const Result result = run_ajar({"info", scene_path("cornell-box"), "--json"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    const Json json = Json::parse(result.out);
    EXPECT_TRUE(json.contains("file"));
    EXPECT_TRUE(json.contains("scene"));
}

TEST(Info, NeedsNoDevice) {
    Surroundings without;
    without.environment = {{"VK_ICD_FILENAMES", "/nowhere"}, {"VK_DRIVER_FILES", "/nowhere"}};
    EXPECT_EQ(run_ajar({"info", scene_path("cornell-box")}, without).exit_code, 0);
}

TEST(Info, OfSomethingElseIsOneLine) {
    const TemporaryFolder folder;
    write_text(folder / "a.glb", "not a scene");
    for (const std::string& file :
         {(folder / "a.glb").string(), (folder / "none.glb").string(), folder.path().string()}) {
        const Result result = run_ajar({"info", file});
        EXPECT_EQ(result.exit_code, 1) << file;
        EXPECT_EQ(result.out, "");
        EXPECT_EQ(lines(result.err).size(), 1u) << result.err;
        EXPECT_NE(result.err.find(file), std::string::npos) << result.err;
    }
}

TEST(Info, AFullDiskBehindARedirectionIsAnError) {
    const std::string command =
        std::string(AJAR_COMMAND) + " info " + scene_path("cornell-box") + " > /dev/full";
    const Result result = run({"sh", "-c", command});
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_NE(result.err.find("standard output"), std::string::npos) << result.err;
}

TEST(Devices, AreListedForPeopleAndForMachines) {
    const Result text = run_ajar({"devices"});
    EXPECT_EQ(text.exit_code, 0) << text.err;
    const Json json = Json::parse(run_ajar({"devices", "--json"}).out);
    ASSERT_GE(json.size(), 1u);
    for (const Json& device : json) {
        EXPECT_NE(text.out.find(device["name"].get<std::string>()), std::string::npos);
        EXPECT_EQ(device["usable"].get<bool>(), device["missing"].empty());
    }
}

TEST(Devices, WithoutADriverOneLineSaysWhatToInstall) {
    const TemporaryFolder folder;
    Surroundings without;
    without.environment = {{"VK_ICD_FILENAMES", "/nowhere"}, {"VK_DRIVER_FILES", "/nowhere"}};
    const std::string out = (folder / "a.png").string();
    for (const std::vector<std::string>& arguments :
         {std::vector<std::string>{"devices"}, {"render", scene_path("cornell-box"), "-o", out}}) {
        const Result result = run_ajar(arguments, without);
        EXPECT_EQ(result.exit_code, 1);
        EXPECT_EQ(lines(result.err).size(), 1u) << result.err;
        EXPECT_NE(result.err.find("mesa-vulkan-drivers"), std::string::npos) << result.err;
    }
    EXPECT_FALSE(std::filesystem::exists(out));
}

} // namespace ajar::test
