// ajar merge: parts of a picture make the picture, and what does not belong together is refused.
#include "cli/run_ajar.hpp"
#include "cli/small_renders.hpp"
#include "image/read.hpp"
#include "support/temporary_folder.hpp"

#include <cmath>
#include <csignal>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace ajar::test {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

class Merge : public testing::Test {
  protected:
    // A tiny Cornell box as 32-bit floats.
    std::string part(const std::string& name, std::vector<std::string> more) const {
        const std::string file = path(name);
        more.insert(more.end(), {"--float", "-o", file});
        const Result result = run_ajar(tiny(more));
        EXPECT_EQ(result.exit_code, 0) << result.err;
        return file;
    }
    std::string path(const std::string& name) const { return (folder_ / name).string(); }

    void expect_refused(const std::vector<std::string>& parts, const std::string& message) const {
        std::vector<std::string> arguments{"merge", "-o", path("merged.exr")};
        arguments.insert(arguments.end(), parts.begin(), parts.end());
        const Result result = run_ajar(arguments);
        EXPECT_EQ(result.exit_code, 1) << result.err;
        EXPECT_EQ(lines(result.err).size(), 1u) << result.err;
        EXPECT_NE(result.err.find(message), std::string::npos) << result.err;
        EXPECT_FALSE(fs::exists(path("merged.exr")));
    }

    TemporaryFolder folder_;
};

Json settings_of(const Image& image) {
    for (const auto& [name, value] : image.metadata)
        if (name == "ajar:settings") return Json::parse(value);
    return {};
}

// Sums of floats that were rounded to floats on the way; the variance is a difference of such sums.
void expect_same_picture(const Image& a, const Image& b) {
    for (const char* name : {"", "variance"}) {
        const Layer &of_a = *a.find(name), &of_b = *b.find(name);
        ASSERT_EQ(of_a.pixels.size(), of_b.pixels.size());
        for (std::size_t i = 0; i < of_a.pixels.size(); ++i) {
            const float scale = std::max(1.0f, std::abs(of_b.pixels[i]));
            ASSERT_NEAR(of_a.pixels[i], of_b.pixels[i], 1e-5f * scale) << name << " " << i;
        }
    }
}

TEST_F(Merge, PartsMakeThePictureOfOneRun) {
    const auto samples = [&](const char* name, const char* first, const char* count) {
        return part(name, {"--sampler", "blue-noise", "--sequence-samples", "16", "--first-sample", first,
                           "--samples", count});
    };
    const std::string a = samples("a.exr", "0", "8"), b = samples("b.exr", "8", "1"),
                      c = samples("c.exr", "9", "7"), whole = samples("whole.exr", "0", "16");
    const std::string merged = path("merged.exr");
    const Result result = run_ajar({"merge", c, a, b, "--float", "-o", merged, "-o", path("m.png")});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(result.err, "");
    const Image made = read_image(merged), right = read_image(whole);
    expect_same_picture(made, right);
    EXPECT_EQ(settings_of(made), settings_of(right)) << "it tells the same of itself";
    EXPECT_EQ(made.metadata.size(), right.metadata.size());
    EXPECT_EQ(read_image(path("m.png")).width, 24u);
}

TEST_F(Merge, WhatWasMergedMergesAgain) {
    const std::string a = part("a.exr", {"--samples", "1"});
    const std::string b = part("b.exr", {"--first-sample", "1", "--samples", "3"});
    const std::string c = part("c.exr", {"--first-sample", "4", "--samples", "4"});
    ASSERT_EQ(run_ajar({"merge", b, a, "--float", "-o", path("ab.exr")}).exit_code, 0);
    ASSERT_EQ(run_ajar({"merge", path("ab.exr"), c, "--float", "-o", path("abc.exr")}).exit_code, 0);
    expect_same_picture(read_image(path("abc.exr")), read_image(part("whole.exr", {"--samples", "8"})));
}

TEST_F(Merge, LeavesOutAttributesAndSaysSo) {
    const std::string a = part("a.exr", {"--aov"});
    const std::string b = part("b.exr", {"--first-sample", "2"});
    const Result result = run_ajar({"merge", a, b, "-o", path("merged.exr")});
    EXPECT_EQ(result.exit_code, 0);
    EXPECT_NE(result.err.find("left out"), std::string::npos) << result.err;
    EXPECT_EQ(read_image(path("merged.exr")).find("albedo"), nullptr);
}

TEST_F(Merge, SamplesThatAreThereTwiceOrNotAtAllAreErrors) {
    const std::string a = part("a.exr", {"--samples", "4"});
    expect_refused({a, a}, "begins with sample 0, which " + a + " has too");
    const std::string b = part("b.exr", {"--first-sample", "3"});
    expect_refused({b, a}, b + ": begins with sample 3, which " + a + " has too");
    const std::string c = part("c.exr", {"--first-sample", "7"});
    expect_refused({a, c}, "render them with --first-sample 4 --samples 3");
}

TEST_F(Merge, APartThatWasInterruptedIsAnError) {
    const std::string a = part("a.exr", {"--samples", "4"}), b = path("b.exr");
    Process process(ajar_command(
        tiny({"--first-sample", "4", "--samples", "100000000", "--float", "-o", b, "--progress", "json"})));
    ASSERT_TRUE(wait_for_samples(process, 1)) << process.finish().err;
    process.send(SIGINT);
    EXPECT_EQ(process.finish().exit_code, 130);
    ASSERT_TRUE(fs::exists(b));
    expect_refused({a, b}, b + ": was interrupted");
}

TEST_F(Merge, PartsOfOtherPicturesAreErrors) {
    const std::string a = part("a.exr", {});
    const auto other = [&](std::vector<std::string> more) {
        more.insert(more.end(), {"--first-sample", "2"});
        return part("b.exr", more);
    };
    expect_refused({a, other({"--seed", "1"})}, "seed is 1, in " + a + " 0");
    expect_refused({a, other({"--max-bounces", "1"})}, "max_bounces is 1");
    expect_refused({a, other({"--size", "16x16"})}, "width is 16");
    const std::string b = path("b.exr");
    ASSERT_EQ(run_ajar({"render", scene_path("textured"), "--size", "24x16", "--samples", "2",
                        "--first-sample", "2", "-o", b})
                  .exit_code,
              0);
    expect_refused({a, b}, "b.exr: ");
}

TEST_F(Merge, FilesThatDoNotTellTheirSamplesAreErrors) {
    const std::string a = part("a.exr", {});
    const std::string shown = path("shown.png");
    ASSERT_EQ(run_ajar(tiny({"-o", shown})).exit_code, 0);
    expect_refused({a, shown}, shown + ": does not tell which samples it holds");
    expect_refused({a, path("missing.exr")}, "missing.exr: ");
}

TEST_F(Merge, OnePartOrNoOutputIsAUsageError) {
    EXPECT_EQ(run_ajar({"merge", "a.exr", "-o", path("merged.exr")}).exit_code, 2);
    EXPECT_EQ(run_ajar({"merge", "a.exr", "b.exr"}).exit_code, 2);
    EXPECT_EQ(run_ajar({"merge"}).exit_code, 2);
}

} // namespace

} // namespace ajar::test
