// ajar bake from outside: what it writes looks the same without any light, is valid glTF and the same bytes
// every time; and what it says when it cannot.
#include "cli/run_ajar.hpp"
#include "cli/small_renders.hpp"
#include "image/read.hpp"
#include "support/temporary_folder.hpp"

#include <csignal>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace ajar::test {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

std::vector<std::string> bake(const fs::path& file, const std::vector<std::string>& more) {
    std::vector<std::string> arguments{"bake", scene_path("cornell-box"), "-o", file.string()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
}

Result expect_success(const std::vector<std::string>& arguments) {
    Result result = run_ajar(arguments);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return result;
}

const std::vector<std::vector<std::string>> TINY_BAKES{{"--patches", "300", "--samples", "4"},
                                                       {"--lightmap", "64", "--samples", "4"},
                                                       {"--occlusion", "64", "--samples", "4"}};

// One line "ajar: error: ...", the exit code, and no file.
void expect_error(const TemporaryFolder& folder, std::vector<std::string> arguments, const std::string& part,
                  int exit_code = 1) {
    arguments.insert(arguments.end(), {"-o", (folder / "baked.glb").string()});
    const Result result = run_ajar(arguments);
    EXPECT_EQ(result.exit_code, exit_code) << result.err;
    EXPECT_EQ(lines(result.err).size(), 1u) << result.err;
    EXPECT_TRUE(result.err.starts_with("ajar: error: ")) << result.err;
    EXPECT_NE(result.err.find(part), std::string::npos) << result.err;
    EXPECT_FALSE(fs::exists(folder / "baked.glb"));
}

} // namespace

// The path traced view against what is baked, rendered without light: unlit materials alone.
TEST(Bake, LooksTheSameWithoutAnyLight) {
    const TemporaryFolder folder;
    const std::string view = (folder / "view.png").string();
    expect_success({"render", scene_path("cornell-box"), "-o", view, "--size", "96x96", "--samples", "512"});
    for (const std::vector<std::string>& how :
         {std::vector<std::string>{"--patches", "6000", "--samples", "256"},
          {"--lightmap", "128", "--samples", "256"}}) {
        SCOPED_TRACE(how[0]);
        const std::string file = (folder / "baked.glb").string(), again = (folder / "again.png").string();
        expect_success(bake(file, how));
        const Json info = Json::parse(expect_success({"info", file, "--json"}).out);
        EXPECT_TRUE(info["scene"]["lights"].empty()) << info.dump();
        expect_success({"render", file, "-o", again, "--size", "96x96", "--samples", "64"});
        const Result compared = run_ajar({"compare", again, view, "--max-flip", "0.05"});
        EXPECT_EQ(compared.exit_code, 0) << compared.out << compared.err;
    }
}

TEST(Bake, WritesTheSameBytesTwice) {
    const TemporaryFolder folder;
    for (const std::vector<std::string>& how : TINY_BAKES) {
        SCOPED_TRACE(how[0]);
        expect_success(bake(folder / "a.glb", how));
        expect_success(bake(folder / "b.glb", how));
        EXPECT_EQ(read_text(folder / "a.glb"), read_text(folder / "b.glb"));
        EXPECT_EQ(fs::exists(folder / "a.exr"), how[0] == "--lightmap");
        if (how[0] != "--lightmap") continue;
        EXPECT_EQ(read_text(folder / "a.exr"), read_text(folder / "b.exr"));
        EXPECT_EQ(read_image(folder / "a.exr").width, 64u);
        fs::remove(folder / "a.exr");
    }
}

TEST(Bake, IsCleanForKhronosValidator) {
    const std::string script = (fs::path(AJAR_SOURCE_DIR) / "tests/cli/validate_gltf.js").string();
    if (run({"sh", "-c", "command -v node"}).exit_code != 0) GTEST_SKIP() << "no node here";
    if (run({"node", script}).exit_code == 2)
        GTEST_SKIP() << "no gltf-validator here (npm install gltf-validator, and NODE_PATH to node_modules)";
    const TemporaryFolder folder;
    for (const char* scene : {"cornell-box", "textured"})
        for (const std::vector<std::string>& how : TINY_BAKES) {
            const fs::path file = folder / (scene + how[0] + ".glb");
            std::vector<std::string> arguments{"bake", scene_path(scene), "-o", file.string()};
            arguments.insert(arguments.end(), how.begin(), how.end());
            expect_success(arguments);
            const Result result = run({"node", script, file.string()});
            EXPECT_EQ(result.exit_code, 0) << result.out << result.err;
        }
}

TEST(Bake, ReportsWhatItDid) {
    const TemporaryFolder folder;
    const Result result =
        expect_success(bake(folder / "a.glb", {"--lightmap", "64", "--samples", "2", "--report",
                                               (folder / "a.json").string(), "--progress", "json"}));
    const Json report = Json::parse(read_text(folder / "a.json"));
    EXPECT_EQ(report["bake"]["to"], "lightmap");
    EXPECT_EQ(report["bake"]["side"], 64);
    EXPECT_GT(report["bake"]["elements"], 1000);
    EXPECT_EQ(report["result"]["samples"], 2);
    std::vector<std::string> written;
    for (const std::string& line : lines(result.out)) {
        const Json event = Json::parse(line);
        if (event["event"] == "written") written.push_back(fs::path(event["file"]).filename());
    }
    EXPECT_EQ(written, (std::vector<std::string>{"a.glb", "a.exr", "a.json"}));
    EXPECT_EQ(Json::parse(lines(result.out).back())["event"], "done");
}

TEST(Bake, NamesWhatLooksAlikeFromEverywhere) {
    const TemporaryFolder folder;
    const Result result = expect_success({"bake", scene_path("glossy-and-specular"), "-o",
                                          (folder / "a.glb").string(), "--patches", "100", "--samples", "1"});
    EXPECT_NE(result.err.find("baked as if diffuse"), std::string::npos) << result.err;
}

TEST(Bake, WhatCannotBeBakedIsOneLine) {
    const TemporaryFolder folder;
    const fs::path dark = folder / "dark.gltf";
    write_triangle(dark);
    expect_error(folder, {"bake", dark.string()}, "dark.gltf: there is no light to bake");
    expect_error(folder, {"bake", scene_path("many-lights-100"), "--lightmap", "16"},
                 "many-lights-100.gltf: an atlas of 16 x 16 texels is too small for");
    const fs::path empty = folder / "empty.gltf";
    write_text(empty, R"({"asset":{"version":"2.0"},"scenes":[{}]})");
    const Result result = run_ajar({"bake", empty.string(), "-o", (folder / "baked.glb").string()});
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_NE(result.err.find("empty.gltf: there are no triangles to bake light on"), std::string::npos)
        << result.err;
    const fs::path flat = folder / "flat.gltf";
    write_glowing_triangle(flat, "1");
    std::string text = read_text(flat); // the third corner becomes the second: base64 of 1, 0, 0
    text.replace(text.find("AAAAAAAAgD8AAAAA"), 16, "AACAPwAAAAAAAAAA");
    write_text(flat, text);
    expect_error(folder, {"bake", flat.string()}, "flat.gltf: none of its triangles has any area");
    expect_error(folder, {"bake", (folder / "nowhere.gltf").string()}, "nowhere.gltf");
}

TEST(Bake, WrongCommandLinesAreUsageErrors) {
    const TemporaryFolder folder;
    const std::string scene = scene_path("cornell-box");
    expect_error(folder, {"bake", scene, "--lightmap", "64", "--occlusion", "64"}, "--lightmap", 2);
    expect_error(folder, {"bake", scene, "--lightmap", "1"}, "--lightmap", 2);
    expect_error(folder, {"bake", scene, "--patches", "0"}, "--patches", 2);
    expect_error(folder, {"bake", scene, "--with", "magic"}, "magic", 2);
    EXPECT_EQ(run_ajar({"bake", scene}).exit_code, 2);
    const Result result = run_ajar({"bake", scene, "-o", (folder / "baked.gltf").string()});
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_NE(result.err.find("is not .glb"), std::string::npos) << result.err;
}

TEST(Bake, CtrlCKeepsTheSamplesDone) {
    const TemporaryFolder folder;
    Process process(ajar_command(
        bake(folder / "a.glb", {"--lightmap", "32", "--samples", "100000000", "--progress", "json"})));
    for (std::string line = process.read_line(); !line.empty(); line = process.read_line()) {
        const Json event = Json::parse(line);
        if (event["event"] == "progress" && event["done"].get<std::uint64_t>() >= 1) break;
    }
    process.send(SIGINT);
    const Result result = process.finish();
    EXPECT_EQ(result.exit_code, 130) << result.err;
    EXPECT_NE(result.err.find("of 100000000 samples done, written to "), std::string::npos) << result.err;
    expect_success({"info", (folder / "a.glb").string()});
    EXPECT_EQ(read_image(folder / "a.exr").width, 32u);
}

} // namespace ajar::test
