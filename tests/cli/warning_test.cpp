// What ajar render says when a picture lacks something.
#include "cli/run_ajar.hpp"
#include "cli/small_renders.hpp"
#include "image/read.hpp"
#include "support/temporary_folder.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace ajar::test {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

bool all_finite(const Layer& layer) {
    return std::all_of(layer.pixels.begin(), layer.pixels.end(),
                       [](float value) { return std::isfinite(value); });
}

// The first number of the only line of stderr, which must begin with "ajar: warning: ".
std::uint64_t only_warning(const Result& result) {
    const std::string start = "ajar: warning: ";
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(lines(result.err).size(), 1u) << result.err;
    EXPECT_TRUE(result.err.starts_with(start)) << result.err;
    return result.err.starts_with(start) ? std::strtoull(result.err.c_str() + start.size(), nullptr, 10) : 0;
}

} // namespace

TEST(RenderWarning, CountsSamplesTooBrightForTheFilm) {
    const TemporaryFolder folder;
    const fs::path scene = folder / "bright.gltf", image = folder / "a.exr", report = folder / "a.json";
    write_glowing_triangle(scene, "1e30");
    const Result result = run_ajar({"render", scene.string(), "-o", image.string(), "--report",
                                    report.string(), "--size", "16x16", "--samples", "2"});
    const std::uint64_t count = only_warning(result);
    EXPECT_GT(count, 0u);
    EXPECT_LE(count, 16u * 16u * 2u);
    EXPECT_NE(result.err.find("samples brighter than 16777216 "), std::string::npos) << result.err;
    EXPECT_EQ(Json::parse(read_text(report))["result"]["saturated_samples"], count);
    EXPECT_TRUE(all_finite(beauty(read_image(image), "a")));

    write_glowing_triangle(scene, "1e6");
    EXPECT_EQ(run_ajar({"render", scene.string(), "-o", image.string(), "--size", "16x16"}).err, "");
}

TEST(RenderWarning, CountsSamplesWithoutAFiniteValue) {
    const TemporaryFolder folder;
    const fs::path scene = folder / "infinite.gltf", image = folder / "a.exr", report = folder / "a.json";
    write_glowing_triangle(scene, "3.4e38");
    const Result result = run_ajar({"render", scene.string(), "-o", image.string(), "--report",
                                    report.string(), "--size", "16x16", "--samples", "2"});
    const std::uint64_t count = only_warning(result);
    EXPECT_GT(count, 0u);
    EXPECT_EQ(Json::parse(read_text(report))["result"]["invalid_samples"], count);
    const Layer black = beauty(read_image(image), "a");
    EXPECT_TRUE(all_finite(black));

    const std::size_t place = result.err.find("(the first: pixel ");
    ASSERT_NE(place, std::string::npos) << result.err;
    unsigned x = 99, y = 99, sample = 99;
    ASSERT_EQ(
        std::sscanf(result.err.c_str() + place, "(the first: pixel %u, %u, sample %u)", &x, &y, &sample), 3)
        << result.err;
    ASSERT_LT(x, 16u);
    ASSERT_LT(y, 16u);
    EXPECT_LT(sample, 2u);
}

} // namespace ajar::test
