// ajar render: what it writes, what it says, and that a failure leaves the old files alone.
#include "cli/run_ajar.hpp"
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

// A tiny Cornell box; further arguments win over these.
std::vector<std::string> tiny(std::vector<std::string> more) {
    std::vector<std::string> arguments{"render", scene_path("cornell-box"), "--size", "24x16", "--samples",
                                       "2"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
}

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

TEST(Render, MetadataReproducesTheImage) {
    const TemporaryFolder folder;
    const fs::path file = folder / "a.exr";
    ASSERT_EQ(run_ajar(tiny({"-o", file.string(), "--seed", "7"})).exit_code, 0);
    std::map<std::string, std::string> metadata;
    for (const auto& [name, value] : read_image(file).metadata) metadata[name] = value;
    const Json settings = Json::parse(metadata["ajar:settings"]);
    EXPECT_EQ(settings["seed"], 7);
    EXPECT_EQ(settings["samples"], 2);
    EXPECT_EQ(settings["width"], 24);
    EXPECT_EQ(metadata["ajar:scene_hash"].size(), 32u);
    EXPECT_EQ(metadata["ajar:shader_hash"].size(), 32u);
    EXPECT_EQ(metadata["ajar:version"], AJAR_VERSION);
    EXPECT_NE(metadata["ajar:device"], "");
}

TEST(Render, ReportTellsWhatTheImageWasMadeOf) {
    const TemporaryFolder folder;
    const fs::path file = folder / "a.json";
    const Result result =
        run_ajar(tiny({"--report", file.string(), "--max-bounces", "3", "--filter", "gaussian"}));
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const Json report = Json::parse(read_text(file));
    EXPECT_EQ(report["ajar"]["version"], AJAR_VERSION);
    EXPECT_EQ(report["scene"]["file"], "cornell-box.gltf");
    EXPECT_EQ(report["scene"]["hash"].get<std::string>().size(), 32u);
    EXPECT_EQ(report["settings"]["max_bounces"], 3);
    EXPECT_EQ(report["settings"]["filter"], "gaussian");
    EXPECT_EQ(report["settings"]["integrator"], "path");
    EXPECT_NE(report["device"]["name"], "");
    EXPECT_NE(report["device"]["driver"], "");
    EXPECT_GE(report["shaders"]["kernels"].size(), 5u);
    EXPECT_EQ(report["result"]["samples"], 2);
    EXPECT_EQ(report["result"]["interrupted"], false);
    EXPECT_EQ(report["rays"]["camera"], 24 * 16 * 2);
    EXPECT_GE(report["rays"]["extension"], report["rays"]["camera"]);
    EXPECT_GT(report["rays"]["shadow"], 0);
    double share = 0;
    for (const auto& kernel : report["time"]["kernels"]) share += kernel["share"].get<double>();
    EXPECT_NEAR(share, 1, 1e-9);
}

TEST(Render, ReportTellsWhatDefaultsStandFor) {
    const TemporaryFolder folder;
    const fs::path file = folder / "a.json";
    const auto report = [&](const std::vector<std::string>& more) {
        std::vector<std::string> arguments = tiny({"--report", file.string()});
        arguments.insert(arguments.end(), more.begin(), more.end());
        const Result result = run_ajar(arguments);
        EXPECT_EQ(result.exit_code, 0) << result.err;
        return Json::parse(read_text(file));
    };
    const Json usual = report({});
    EXPECT_EQ(usual["settings"]["filter_radius"], 0.5);
    EXPECT_GT(usual["settings"]["ao_distance"], 0);
    const unsigned segment = usual["speed"]["segment_paths"];
    const unsigned pool = usual["speed"]["pool_paths"];
    ASSERT_GT(segment, 0u);
    EXPECT_GE(pool, 24u * 16u) << "the picture fits into the least pool";
    EXPECT_EQ(pool % segment, 0u) << "whole segments";

    EXPECT_EQ(report({"--filter", "gaussian"})["settings"]["filter_radius"], 1.5);
    const Json asked =
        report({"--filter-radius", "0.75", "--ao-distance", "2", "--pool", "100", "--segment", "64"});
    EXPECT_EQ(asked["settings"]["filter_radius"], 0.75);
    EXPECT_EQ(asked["settings"]["ao_distance"], 2);
    EXPECT_EQ(asked["speed"]["segment_paths"], 64);
    EXPECT_EQ(asked["speed"]["pool_paths"], 128) << "whole segments";
}

TEST(Render, ADefaultThatIsSpelledOutGivesTheSameFile) {
    const TemporaryFolder folder;
    const fs::path plain = folder / "a.exr", spelled = folder / "b.exr";
    ASSERT_EQ(run_ajar(tiny({"-o", plain.string()})).exit_code, 0);
    ASSERT_EQ(run_ajar(tiny({"-o", spelled.string(), "--filter", "box", "--filter-radius", "0.5"})).exit_code,
              0);
    EXPECT_TRUE(read_text(plain) == read_text(spelled));
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
    write_text(scene, R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],
        "meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],
        "accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3",
        "min":[0,0,0],"max":[1,1,0]}],
        "bufferViews":[{"buffer":0,"byteLength":36}],"buffers":[{"byteLength":36,"uri":
        "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]})");
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
