// ajar lab: what it writes, what its figures are, and what it keeps.
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

const std::vector<std::string> FILES{"contact-sheet.png", "error-samples.svg", "error-seconds.svg",
                                     "lab.json",          "table.csv",         "table.md"};

Result run_lab(const fs::path& folder, const std::vector<std::string>& more) {
    return run_ajar(lab(folder.string(), more));
}

std::size_t references_in(const fs::path& folder) {
    std::size_t count = 0;
    for (const auto& entry : fs::directory_iterator(folder))
        count += entry.path().filename().string().starts_with("reference-");
    return count;
}

} // namespace

TEST(Lab, WritesTablesPlotsAndASheet) {
    const TemporaryFolder folder;
    const fs::path out = folder / "made" / "on the way";
    const Result result = run_lab(out, {"--samples", "16", "--integrators", "path,naive"});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    for (const std::string& name : FILES) EXPECT_GT(fs::file_size(out / name), 0u) << name;
    EXPECT_EQ(result.out, read_text(out / "table.md"));
    EXPECT_NE(result.out.find("| naive "), std::string::npos) << result.out;
    EXPECT_GT(read_image(out / "contact-sheet.png").width, 600u);
    EXPECT_EQ(lines(read_text(out / "table.csv")).size(), 1 + 2 * 5u) << "1, 2, 4, 8 and 16 samples";
    for (const auto& entry : fs::directory_iterator(out))
        EXPECT_EQ(entry.path().string().find(".partial"), std::string::npos) << entry.path();
}

TEST(Lab, JsonHoldsTheCurveOfEveryCase) {
    const TemporaryFolder folder;
    ASSERT_EQ(run_lab(folder / "out", {"--samples", "24", "--strategies", "mis,light"}).exit_code, 0);
    const Json json = Json::parse(read_text(folder / "out" / "lab.json"));
    EXPECT_EQ(json["equal"]["samples"], 24);
    EXPECT_EQ(json["interrupted"], false);
    EXPECT_EQ(json["reference"]["samples"], 24 * 16);
    EXPECT_GT(json["reference"]["noise_relmse"].get<double>(), 0);
    EXPECT_EQ(json["scene"]["hash"].get<std::string>().size(), 32u);
    EXPECT_EQ(json["shaders"]["hash"].get<std::string>().size(), 32u);
    EXPECT_EQ(json["device"].count("driver"), 1u);
    ASSERT_EQ(json["cases"].size(), 2u);
    EXPECT_EQ(json["cases"][0]["gain"], 1.0);
    for (const Json& c : json["cases"]) {
        EXPECT_EQ(c["settings"]["strategy"], c["name"]);
        EXPECT_EQ(c["settings"]["samples"], 24);
        std::vector<int> samples;
        for (const Json& point : c["checkpoints"]) samples.push_back(point["samples"]);
        EXPECT_EQ(samples, (std::vector<int>{1, 2, 4, 8, 16, 24}));
        const Json &first = c["checkpoints"].front(), &last = c["checkpoints"].back();
        EXPECT_GT(last["seconds"].get<double>(), first["seconds"].get<double>());
        // 24 times the samples; a third of what that promises is far beyond chance over 768 values.
        EXPECT_LT(last["relmse"].get<double>(), first["relmse"].get<double>() / 8);
        EXPECT_EQ(last["relmse"], c["relmse"]);
        EXPECT_GT(c["rays"].get<std::uint64_t>(), 16u * 16 * 24);
        EXPECT_GE(c["shadow_rays"], c["shadow_rays_open"]);
        EXPECT_EQ(c["mean"]["agrees"], true) << c["name"];
        EXPECT_GT(c["slope"]["standard_error"].get<double>(), 0);
    }
}

TEST(Lab, MeasuresTheErrorThatCompareMeasures) {
    const TemporaryFolder folder;
    const std::string a = (folder / "a.exr").string(), r = (folder / "r.exr").string();
    const std::vector<std::string> scene{"render", scene_path("cornell-box"), "--size", "16x16", "--float"};
    const auto render = [&](std::vector<std::string> more) {
        more.insert(more.begin(), scene.begin(), scene.end());
        ASSERT_EQ(run_ajar(more).exit_code, 0);
    };
    render({"--samples", "8", "-o", a});
    render({"--samples", "64", "--seed", "9", "-o", r});
    ASSERT_EQ(run_lab(folder / "out", {"--samples", "8", "--reference", r}).exit_code, 0);
    const Json json = Json::parse(read_text(folder / "out" / "lab.json"));
    const Json compared = Json::parse(run_ajar({"compare", a, r, "--json"}).out);
    const auto expected = compared["relmse"].get<double>();
    EXPECT_NEAR(json["cases"][0]["relmse"].get<double>(), expected, 1e-5 * expected)
        << "ranges merged against one render, up to the rounding of floats";
    EXPECT_EQ(json["reference"]["given"], true);
    EXPECT_EQ(references_in(folder / "out"), 0u);
}

TEST(Lab, SeesThatACaseLacksLight) {
    const TemporaryFolder folder;
    const Result result = run_lab(folder / "out", {"--samples", "32", "--case", "direct: --max-bounces 0",
                                                   "--case", "all: --max-bounces 12"});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const Json json = Json::parse(read_text(folder / "out" / "lab.json"));
    EXPECT_EQ(json["cases"][0]["mean"]["agrees"], false);
    EXPECT_LT(json["cases"][0]["mean_shift"].get<double>(), 0);
    EXPECT_EQ(json["cases"][1]["mean"]["agrees"], true);
    EXPECT_NE(result.out.find("biased or blind to some light"), std::string::npos) << result.out;
}

TEST(LabReference, IsKeptReusedAndContinued) {
    const TemporaryFolder folder;
    const std::string cache = (folder / "cache").string();
    const auto reference = [&](std::vector<std::string> more) {
        more.insert(more.end(), {"--cache", cache, "--samples", "2"});
        const Result result = run_lab(folder / "out", more);
        EXPECT_EQ(result.exit_code, 0) << result.err;
        return Json::parse(read_text(folder / "out" / "lab.json"))["reference"];
    };
    const Json first = reference({"--reference-samples", "32"});
    EXPECT_EQ(first["samples_found"], 0);
    EXPECT_EQ(first["samples"], 32);
    const Json again = reference({"--reference-samples", "32", "--strategies", "light"});
    EXPECT_EQ(again["samples_found"], 32);
    EXPECT_EQ(again["samples"], 32);
    EXPECT_EQ(again["noise_relmse"], first["noise_relmse"]);
    const Json more = reference({"--reference-samples", "64"});
    EXPECT_EQ(more["samples_found"], 32);
    EXPECT_EQ(more["samples"], 64);
    EXPECT_EQ(references_in(cache), 1u);
    const Json other = reference({"--reference-samples", "32", "--max-bounces", "1"});
    EXPECT_EQ(other["samples_found"], 0) << "other settings, another reference";
    EXPECT_EQ(references_in(cache), 2u);
}

TEST(LabReference, ThatIsBrokenIsReplaced) {
    const TemporaryFolder folder;
    const std::vector<std::string> options{"--samples", "2", "--reference-samples", "8"};
    ASSERT_EQ(run_lab(folder / "out", options).exit_code, 0);
    for (const auto& entry : fs::directory_iterator(folder / "out"))
        if (entry.path().extension() == ".exr") write_text(entry.path(), "no image");
    const Result result = run_lab(folder / "out", options);
    EXPECT_EQ(result.exit_code, 0);
    EXPECT_NE(result.err.find("kept reference replaced"), std::string::npos) << result.err;
    EXPECT_EQ(Json::parse(read_text(folder / "out" / "lab.json"))["reference"]["samples_found"], 0);
}

TEST(LabReference, ThatDoesNotFitIsAnError) {
    const TemporaryFolder folder;
    const std::string small = (folder / "small.exr").string(), shown = (folder / "shown.png").string();
    ASSERT_EQ(run_ajar({"render", scene_path("cornell-box"), "--size", "8x8", "--samples", "1", "-o", small,
                        "-o", shown})
                  .exit_code,
              0);
    for (const std::string& file : {small, shown, (folder / "missing.exr").string()}) {
        const Result result = run_lab(folder / "out", {"--reference", file});
        EXPECT_EQ(result.exit_code, 1);
        EXPECT_EQ(lines(result.err).size(), 1u) << result.err;
        EXPECT_NE(result.err.find(file), std::string::npos) << result.err;
    }
}

TEST(Lab, GivesEveryCaseTheSameTime) {
    const TemporaryFolder folder;
    const Result result = run_lab(
        folder / "out", {"--seconds", "0.3", "--reference-samples", "64", "--integrators", "naive,path"});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const Json json = Json::parse(read_text(folder / "out" / "lab.json"));
    EXPECT_EQ(json["equal"]["seconds"], 0.3);
    for (const Json& c : json["cases"]) EXPECT_GE(c["samples"], 1);
}

TEST(Lab, SheetHasAColumnForEachNumberOfSamples) {
    const TemporaryFolder folder;
    const auto sheet = [&](const std::string& stops) {
        const Result result =
            run_lab(folder / "out", {"--samples", "6", "--sheet-samples", stops, "--reference-samples", "8"});
        EXPECT_EQ(result.exit_code, 0) << result.err;
        return read_image(folder / "out" / "contact-sheet.png");
    };
    const Image one = sheet("6"), two = sheet("3,6"), three = sheet("1,3,6");
    EXPECT_EQ(three.width - two.width, two.width - one.width);
    EXPECT_EQ(three.height, one.height);
}

TEST(Lab, CtrlCKeepsTheCasesThatAreFinished) {
    const TemporaryFolder folder;
    const std::string reference = (folder / "r.exr").string();
    ASSERT_EQ(
        run_ajar({"render", scene_path("cornell-box"), "--size", "16x16", "--samples", "4", "-o", reference})
            .exit_code,
        0);
    Process process(ajar_command(
        lab((folder / "out").string(), {"--seconds", "2", "--reference", reference, "--strategies",
                                        "mis,light,bsdf", "--progress", "json"})));
    bool second = false;
    for (std::string line = process.read_line(); !second && !line.empty(); line = process.read_line())
        second = Json::parse(line).value("stage", "").starts_with("case 2 of 3");
    ASSERT_TRUE(second);
    process.send(SIGINT);
    const Result result = process.finish();
    EXPECT_EQ(result.exit_code, 130);
    EXPECT_NE(result.err.find("1 of 3 cases done"), std::string::npos) << result.err;
    for (const std::string& name : FILES) EXPECT_TRUE(fs::exists(folder / "out" / name)) << name;
    const Json json = Json::parse(read_text(folder / "out" / "lab.json"));
    EXPECT_EQ(json["interrupted"], true);
    EXPECT_EQ(json["cases"].size(), 1u);
}

TEST(Lab, CtrlCDuringTheReferenceWritesNoResults) {
    const TemporaryFolder folder;
    Process process(
        ajar_command(lab((folder / "out").string(), {"--samples", "10000000", "--progress", "json"})));
    double share = 0;
    for (std::string line = process.read_line(); share == 0 && !line.empty(); line = process.read_line())
        share = Json::parse(line).value("share", 0.0);
    process.send(SIGTERM);
    const Result result = process.finish();
    EXPECT_EQ(result.exit_code, 130);
    for (const std::string& name : FILES) EXPECT_FALSE(fs::exists(folder / "out" / name)) << name;
}

} // namespace ajar::test
