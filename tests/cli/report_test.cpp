// What ajar render tells of an image: in its metadata and in --report.
#include "cli/run_ajar.hpp"
#include "cli/small_renders.hpp"
#include "image/read.hpp"
#include "support/temporary_folder.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace ajar::test {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

} // namespace

TEST(Metadata, ReproducesTheImage) {
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

TEST(Report, TellsWhatTheImageWasMadeOf) {
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
    EXPECT_EQ(report["settings"]["naive_sampling"], "bsdf");
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

TEST(Report, TellsWhatDefaultsStandFor) {
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

TEST(Metadata, ADefaultThatIsSpelledOutGivesTheSameFile) {
    const TemporaryFolder folder;
    const fs::path plain = folder / "a.exr", spelled = folder / "b.exr";
    ASSERT_EQ(run_ajar(tiny({"-o", plain.string()})).exit_code, 0);
    ASSERT_EQ(run_ajar(tiny({"-o", spelled.string(), "--filter", "box", "--filter-radius", "0.5"})).exit_code,
              0);
    EXPECT_TRUE(read_text(plain) == read_text(spelled));
}

} // namespace ajar::test
