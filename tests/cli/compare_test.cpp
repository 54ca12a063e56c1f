// ajar compare: verdicts and their exit codes, on images that the test writes itself.
#include "cli/run_ajar.hpp"
#include "image/read.hpp"
#include "image/write.hpp"
#include "support/temporary_folder.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <nlohmann/json.hpp>

namespace ajar::test {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr std::uint32_t SIDE = 32;

// All pixels have this radiance and this variance of the mean (negative: no such layer).
void write_constant(const fs::path& file, float radiance, float variance, std::uint32_t side = SIDE) {
    Image image;
    image.width = image.height = side;
    for (float& value : image.add("", {"R", "G", "B", "A"}).pixels) value = radiance;
    if (variance >= 0)
        for (float& value : image.add("variance", {"R", "G", "B"}).pixels) value = variance;
    WriteOptions options;
    options.exr_floats = ExrFloats::full;
    write_image(file, image, options);
}

struct Compare : testing::Test {
    TemporaryFolder folder;
    std::string a = (folder / "a.exr").string(), b = (folder / "b.exr").string();

    int exit_code(const std::vector<std::string>& more = {}) {
        std::vector<std::string> arguments{"compare", a, b};
        arguments.insert(arguments.end(), more.begin(), more.end());
        last = run_ajar(arguments);
        return last.exit_code;
    }
    Result last;
};

} // namespace

TEST_F(Compare, EqualImagesAreTheSame) {
    write_constant(a, 0.5f, -1);
    write_constant(b, 0.5f, -1);
    EXPECT_EQ(exit_code(), 0) << last.err;
    EXPECT_EQ(lines(last.out).back(), "same");
}

TEST_F(Compare, WithoutVarianceAnyDifferenceCounts) {
    write_constant(a, 0.5f, -1);
    write_constant(b, 0.5001f, -1);
    EXPECT_EQ(exit_code(), 3);
    EXPECT_TRUE(lines(last.out).back().starts_with("different: ")) << last.out;
    EXPECT_EQ(last.err, "");
}

// Each of the 32 x 32 pixels is off by d with variance v in both: z = d sqrt(1024) / sqrt(2 v) over the whole
// image.
TEST_F(Compare, NoiseIsNoDifferenceWhereVarianceExplainsIt) {
    const double v = 0.01, one_sigma = std::sqrt(2 * v / (SIDE * SIDE));
    write_constant(a, static_cast<float>(0.5 + one_sigma), static_cast<float>(v));
    write_constant(b, 0.5f, static_cast<float>(v));
    EXPECT_EQ(exit_code(), 0) << last.out;
    write_constant(a, static_cast<float>(0.5 + 8 * one_sigma), static_cast<float>(v));
    EXPECT_EQ(exit_code(), 3) << last.out;
    EXPECT_EQ(exit_code({"--max-rmse", "0.1"}), 0) << "limits alone decide" << last.out;
    EXPECT_EQ(exit_code({"--max-rmse", "0.1", "--significance", "1e-4"}), 3)
        << "unless noise is asked for" << last.out;
}

TEST_F(Compare, EachLimitDecides) {
    write_constant(a, 0.6f, -1);
    write_constant(b, 0.5f, -1); // RMSE and largest error 0.1; relMSE 0.01 / 0.26 = 0.0385
    for (const auto& [option, below, above] :
         std::vector<std::array<std::string, 3>>{{"--max-rmse", "0.099", "0.101"},
                                                 {"--max-error", "0.099", "0.101"},
                                                 {"--max-relmse", "0.038", "0.039"},
                                                 {"--max-flip", "0", "1"}}) {
        EXPECT_EQ(exit_code({option, below}), 3) << option;
        EXPECT_EQ(exit_code({option, above}), 0) << option;
    }
}

TEST_F(Compare, JsonSaysTheSameAsTheExitCode) {
    write_constant(a, 0.6f, 0.01f);
    write_constant(b, 0.5f, 0.01f);
    EXPECT_EQ(exit_code({"--json"}), 3);
    const Json json = Json::parse(last.out);
    EXPECT_EQ(json["same"], false);
    EXPECT_GE(json["reasons"].size(), 1u);
    EXPECT_NEAR(json["rmse"].get<double>(), 0.1, 1e-6);
    EXPECT_EQ(json["width"], SIDE);
    EXPECT_LT(json["z_test"]["image"]["p"], 1e-4);
    EXPECT_EQ(exit_code({"--json", "--max-rmse", "1"}), 0);
    EXPECT_EQ(Json::parse(last.out)["same"], true);
}

TEST_F(Compare, TheHeatMapIsAnImageOfTheSameSize) {
    write_constant(a, 0.6f, -1);
    write_constant(b, 0.5f, -1);
    const fs::path map = folder / "map.png";
    EXPECT_EQ(exit_code({"--diff", map.string()}), 3);
    const Image image = read_image(map);
    EXPECT_EQ(image.width, SIDE);
    EXPECT_EQ(image.height, SIDE);
}

TEST_F(Compare, WhatCannotBeComparedIsAnErrorAndNoVerdict) {
    const auto expect_error = [&](const std::string& part, const std::vector<std::string>& more = {}) {
        EXPECT_EQ(exit_code(more), 1) << last.out << last.err;
        EXPECT_EQ(last.out, "");
        EXPECT_EQ(lines(last.err).size(), 1u) << last.err;
        EXPECT_NE(last.err.find(part), std::string::npos) << last.err;
    };
    write_constant(a, 0.5f, -1);
    expect_error("b.exr: no such file");
    write_constant(b, 0.5f, -1, SIDE + 1);
    expect_error("33 x 33");
    write_constant(b, std::numeric_limits<float>::quiet_NaN(), -1);
    expect_error("nan");
    write_text(b, "no image at all");
    expect_error("b.exr");
    write_constant(b, 0.5f, -1);
    expect_error("variance", {"--significance", "0.01"});
    expect_error("missing", {"--diff", (folder / "missing/map.png").string()});
    EXPECT_EQ(exit_code({"--max-flip", "lots"}), 2);
    EXPECT_EQ(exit_code({"--z-scale", "universe"}), 2);
}

} // namespace ajar::test
