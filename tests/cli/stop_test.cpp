// What ends a render early: Ctrl-C, SIGTERM, a time limit. What is done is kept, and no half file is ever
// left.
#include "cli/run_ajar.hpp"
#include "cli/small_renders.hpp"
#include "image/read.hpp"
#include "support/temporary_folder.hpp"

#include <algorithm>
#include <cmath>
#include <csignal>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace ajar::test {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

std::vector<std::string> endless(const fs::path& output) {
    return ajar_command({"render", scene_path("cornell-box"), "--size", "32x32", "--samples", "100000000",
                         "-o", output.string(), "--progress", "json"});
}

std::vector<std::string> files_in(const fs::path& folder) {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder))
        names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
}

void expect_stops_with_an_image(int signal) {
    const TemporaryFolder folder;
    const fs::path output = folder / "a.exr";
    Process process(endless(output));
    ASSERT_TRUE(wait_for_samples(process, 1)) << process.finish().err;
    process.send(signal);
    const Result result = process.finish();
    EXPECT_EQ(result.exit_code, 130) << result.err;
    EXPECT_NE(result.err.find("of 100000000 samples done, written to "), std::string::npos) << result.err;
    const Json last = Json::parse(lines(result.out).back());
    EXPECT_EQ(last["event"], "done");
    EXPECT_EQ(last["interrupted"], true);
    const Image image = read_image(output);
    EXPECT_EQ(image.width, 32u);
    const Layer& pixels = beauty(image, "a.exr");
    double sum = 0;
    for (const float value : pixels.pixels) sum += value;
    EXPECT_TRUE(std::isfinite(sum));
    EXPECT_GT(sum, 0);
    for (const auto& [name, value] : image.metadata)
        if (name == "ajar:settings") {
            EXPECT_EQ(Json::parse(value)["samples"], last["samples"]);
        }
    EXPECT_EQ(files_in(folder.path()), std::vector<std::string>{"a.exr"});
}

} // namespace

TEST(Stop, CtrlCWritesTheSamplesDone) { expect_stops_with_an_image(SIGINT); }

TEST(Stop, SigtermWritesTheSamplesDone) { expect_stops_with_an_image(SIGTERM); }

TEST(Stop, EveryPixelHasAtLeastTheSamplesThatAreReported) {
    const TemporaryFolder folder;
    Process process(endless(folder / "a.exr"));
    ASSERT_TRUE(wait_for_samples(process, 1));
    process.send(SIGINT);
    const auto reported = Json::parse(lines(process.finish().out).back())["samples"].get<float>();
    EXPECT_GE(reported, 1);
    const Image image = read_image(folder / "a.exr");
    for (const float count : image.find("samples")->pixels) ASSERT_GE(count, reported);
}

TEST(Stop, BeforeTheFirstSampleNothingIsWritten) {
    const TemporaryFolder folder;
    const fs::path output = folder / "a.exr";
    write_text(output, "the old one");
    Process process(endless(output));
    process.read_line(); // the first event: it loads
    process.send(SIGINT);
    const Result result = process.finish();
    EXPECT_EQ(result.exit_code, 130);
    EXPECT_NE(result.err.find("nothing was written"), std::string::npos) << result.err;
    EXPECT_EQ(read_text(output), "the old one");
    EXPECT_EQ(files_in(folder.path()), std::vector<std::string>{"a.exr"});
}

TEST(Stop, ASecondCtrlCLeavesNoHalfFile) {
    const TemporaryFolder folder;
    const fs::path output = folder / "a.exr";
    Process process(endless(output));
    ASSERT_TRUE(wait_for_samples(process, 1));
    process.send(SIGINT);
    process.send(SIGTERM);
    EXPECT_EQ(process.finish().exit_code, 130);
    if (fs::exists(output)) {
        EXPECT_EQ(read_image(output).width, 32u);
    }
    EXPECT_LE(files_in(folder.path()).size(), 1u);
}

TEST(Stop, ATimeLimitKeepsWhatIsDone) {
    const TemporaryFolder folder;
    const std::string output = (folder / "a.exr").string(), report = (folder / "a.json").string();
    const Result result = run_ajar({"render", scene_path("cornell-box"), "--size", "32x32", "--samples",
                                    "100000000", "--time-limit", "0.5", "-o", output, "--report", report});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_NE(result.err.find("time limit: "), std::string::npos) << result.err;
    const Json json = Json::parse(read_text(report));
    EXPECT_EQ(json["result"]["out_of_time"], true);
    EXPECT_EQ(json["result"]["samples_asked"], 100000000);
    EXPECT_GE(json["result"]["samples"], 1);
    EXPECT_LT(json["result"]["samples"], 100000000);
    EXPECT_EQ(read_image(output).width, 32u);
}

TEST(Stop, AReaderThatGoesAwayDoesNotEndTheRender) {
    const TemporaryFolder folder;
    const std::string output = (folder / "a.png").string();
    const std::string command = std::string(AJAR_COMMAND) + " render " + scene_path("cornell-box") +
                                " --size 16x16 --samples 4 --progress json -o " + output + " | head -n 1";
    EXPECT_EQ(run({"sh", "-c", command}).exit_code, 0);
    EXPECT_EQ(read_image(output).width, 16u);
}

} // namespace ajar::test
