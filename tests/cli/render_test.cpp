// ajar render: what it writes, what it says, and that a failure leaves the old files alone.
#include "cli/run_ajar.hpp"
#include "cli/small_renders.hpp"
#include "image/read.hpp"
#include "support/temporary_folder.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace ajar::test {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

// One line "ajar: error: ...", exit code 1, and no file of ours left in the folder.
void expect_world_error(const std::vector<std::string>& arguments, const std::string& part) {
    const Result result = run_ajar(arguments);
    EXPECT_EQ(result.exit_code, 1) << result.err;
    EXPECT_TRUE(result.err.starts_with("ajar: error: ")) << result.err;
    EXPECT_EQ(lines(result.err).size(), 1u) << result.err;
    EXPECT_NE(result.err.find(part), std::string::npos) << result.err;
}

std::size_t file_count(const fs::path& folder) {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

bool is_finite(const Layer& layer) {
    return std::all_of(layer.pixels.begin(), layer.pixels.end(),
                       [](float value) { return std::isfinite(value); });
}

} // namespace

TEST(Render, WritesEveryFormatAskedFor) {
    const TemporaryFolder folder;
    std::vector<std::string> arguments = tiny({});
    for (const char* name : {"a.exr", "a.png", "a.jpg", "a.hdr"}) {
        arguments.emplace_back("-o");
        arguments.push_back((folder / name).string());
    }
    const Result result = run_ajar(arguments);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(result.err, "") << "quiet where stderr is no terminal";
    EXPECT_EQ(file_count(folder.path()), 4u);
    for (const char* name : {"a.exr", "a.png", "a.jpg", "a.hdr"}) {
        const Image image = read_image(folder / name);
        EXPECT_EQ(image.width, 24u) << name;
        EXPECT_EQ(image.height, 16u) << name;
        EXPECT_TRUE(is_finite(beauty(image, name))) << name;
    }
}

TEST(Render, WritesTheLayersThatAovAsksFor) {
    const TemporaryFolder folder;
    const std::string file = (folder / "a.exr").string();
    ASSERT_EQ(run_ajar(tiny({"-o", file})).exit_code, 0);
    const Image plain = read_image(file);
    EXPECT_NE(plain.find("variance"), nullptr);
    EXPECT_EQ(plain.find("albedo"), nullptr);
    ASSERT_EQ(run_ajar(tiny({"-o", file, "--aov", "--float"})).exit_code, 0);
    const Image full = read_image(file);
    for (const char* layer : {"variance", "albedo", "normal", "position", "depth", "emission", "object_id",
                              "material_id", "samples"})
        EXPECT_NE(full.find(layer), nullptr) << layer;
}

TEST(Render, GivesTheSameBytesWhateverOnlyChangesTheSpeed) {
    const TemporaryFolder folder;
    const auto bytes = [&](const std::vector<std::string>& more) {
        const fs::path file = folder / "a.exr";
        std::vector<std::string> arguments = tiny({"-o", file.string(), "--aov"});
        arguments.insert(arguments.end(), more.begin(), more.end());
        const Result result = run_ajar(arguments);
        EXPECT_EQ(result.exit_code, 0) << result.err;
        return read_text(file);
    };
    const std::string once = bytes({});
    EXPECT_TRUE(once == bytes({}));
    EXPECT_TRUE(once == bytes({"--no-cache"}));
    EXPECT_TRUE(once == bytes({"--slice", "0.01", "--pool", "256", "--segment", "64"}));
    EXPECT_TRUE(once == bytes({"--pointers"}));
    EXPECT_FALSE(once == bytes({"--seed", "1"}));
}

TEST(Render, ProgressForMachinesIsAnObjectALine) {
    const TemporaryFolder folder;
    const std::string file = (folder / "a.png").string();
    const Result result = run_ajar(tiny({"-o", file, "--progress", "json", "--samples", "8"}));
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(result.err, "");
    std::vector<std::string> events;
    Json last_progress, written;
    for (const std::string& line : lines(result.out)) {
        const Json event = Json::parse(line);
        events.push_back(event["event"]);
        if (event["event"] == "progress") last_progress = event;
        if (event["event"] == "written") written = event;
    }
    ASSERT_FALSE(events.empty());
    EXPECT_EQ(events.front(), "stage");
    EXPECT_EQ(events.back(), "done");
    EXPECT_EQ(last_progress["done"], 8);
    EXPECT_EQ(last_progress["total"], 8);
    EXPECT_EQ(written["file"], file);
}

// script(1) gives it a terminal.
TEST(Render, ATerminalSeesRateAndRemainingTimeInALineThatIsRewritten) {
    if (run({"script", "--quiet", "--return", "--command", "true", "/dev/null"}).exit_code != 0)
        GTEST_SKIP() << "no terminals can be made here (a container without /dev/pts)";
    const TemporaryFolder folder;
    const fs::path file = folder / "a.png";
    std::string command = AJAR_COMMAND;
    for (const std::string& argument : tiny({"-o", file.string()})) command += " " + argument;
    const Result result = run({"script", "--quiet", "--return", "--command", command, "/dev/null"});
    EXPECT_EQ(result.exit_code, 0) << result.out;
    EXPECT_NE(result.out.find("\r\x1b[K2/2 samples  "), std::string::npos) << result.out;
    EXPECT_NE(result.out.find("/s  0:00 left"), std::string::npos) << result.out;
    EXPECT_EQ(lines(result.out).size(), 1u) << result.out;
    EXPECT_NE(result.out.find(" Mrays/s: " + file.string()), std::string::npos) << result.out;
}

TEST(Render, WithoutAnyLightTakesADefaultEnvironmentAndSaysSo) {
    const TemporaryFolder folder;
    const fs::path scene = folder / "triangle.gltf";
    write_triangle(scene);
    const fs::path image = folder / "a.exr";
    const std::vector<std::string> arguments{"render",       scene.string(), "-o",
                                             image.string(), "--size",       "16x16"};
    const Result result = run_ajar(arguments);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_NE(result.err.find("no light"), std::string::npos) << result.err;
    EXPECT_GT(beauty(read_image(image), "a").pixels[0], 0.0f) << "the background is lit as well";

    std::vector<std::string> black = arguments;
    black.insert(black.end(), {"--background", "0,0,0"});
    const Result dark = run_ajar(black);
    EXPECT_EQ(dark.exit_code, 0) << dark.err;
    EXPECT_EQ(dark.err.find("no light"), std::string::npos) << dark.err;
    EXPECT_EQ(beauty(read_image(image), "a").pixels[0], 0.0f) << "asked for, so no default";
}

TEST(Render, AWrongSceneIsOneClearLine) {
    const TemporaryFolder folder;
    const std::string out = (folder / "a.png").string();
    expect_world_error({"render", (folder / "none.glb").string(), "-o", out}, "none.glb");
    expect_world_error({"render", folder.path().string(), "-o", out}, "folder");
    write_text(folder / "noise.glb", "glTF, but not really");
    expect_world_error({"render", (folder / "noise.glb").string(), "-o", out}, "noise.glb");
    write_text(folder / "index.gltf", R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[4711]}]})");
    expect_world_error({"render", (folder / "index.gltf").string(), "-o", out}, "index.gltf");
    write_text(
        folder / "cycle.gltf",
        R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"children":[0]}]})");
    expect_world_error({"render", (folder / "cycle.gltf").string(), "-o", out}, "cycle.gltf");
    expect_world_error(tiny({"-o", out, "--camera", "no such camera"}), "no such camera");
    expect_world_error(tiny({"-o", out, "--scene", "7"}), "7");
    expect_world_error(tiny({"-o", out, "--env", (folder / "none.hdr").string()}), "none.hdr");
    expect_world_error(tiny({"-o", out, "--device", "no such device"}), "no such device");
    EXPECT_FALSE(fs::exists(out));
}

TEST(Render, AnOutputThatCannotBeWrittenIsSaidBeforeRendering) {
    const TemporaryFolder folder;
    const std::vector<std::pair<std::string, std::string>> bad{
        {"a.tiff", ".tiff"}, {"noextension", "noextension"}, {"missing/a.png", "missing"}};
    for (const auto& [name, part] : bad)
        expect_world_error({"render", "not even looked at.glb", "-o", (folder / name).string()}, part);
    fs::create_directory(folder / "folder.png");
    expect_world_error({"render", "not even looked at.glb", "-o", (folder / "folder.png").string()},
                       "folder");
    expect_world_error({"render", "not even looked at.glb", "--report", (folder / "missing/a.json").string()},
                       "missing");
}

TEST(Render, AFailureLeavesTheOldFile) {
    const TemporaryFolder folder;
    const fs::path out = folder / "a.exr";
    write_text(out, "the old one");
    write_text(folder / "bad.gltf", "{");
    EXPECT_EQ(run_ajar({"render", (folder / "bad.gltf").string(), "-o", out.string()}).exit_code, 1);
    EXPECT_EQ(read_text(out), "the old one");

    Surroundings full_disk;
    full_disk.max_file_bytes = 1000;
    const Result result = run_ajar(tiny({"-o", out.string(), "--no-cache", "--size", "64x64"}), full_disk);
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_NE(result.err.find("a.exr"), std::string::npos) << result.err;
    EXPECT_EQ(lines(result.err).size(), 1u) << result.err;
    EXPECT_EQ(read_text(out), "the old one");
    EXPECT_EQ(file_count(folder.path()), 2u) << "no partial file is left";
}

TEST(Render, LaterOptionsWin) {
    const TemporaryFolder folder;
    const std::string file = (folder / "a.png").string();
    ASSERT_EQ(run_ajar(tiny({"-o", file, "--size", "5x7", "--size", "8x9"})).exit_code, 0);
    const Image image = read_image(file);
    EXPECT_EQ(image.width, 8u);
    EXPECT_EQ(image.height, 9u);
}

TEST(Render, ValidationLayerHasNothingToSay) {
    const TemporaryFolder folder;
    const Result result = run_ajar(tiny({"-o", (folder / "a.exr").string(), "--aov", "--validate"}));
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(result.err, "");
}

} // namespace ajar::test
