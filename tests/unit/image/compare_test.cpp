// Errors by hand on small images, what is refused, verdicts, and the colours of the heat map.
#include "base/file.hpp"
#include "folder.hpp"
#include "image/compare.hpp"
#include "image/read.hpp"
#include "image/srgb.hpp"
#include "image/write.hpp"
#include "pictures.hpp"

#include <cmath>

namespace ajar::test {
namespace {

// 2 x 1 pixels; only red of the first differs: 1 against 0.5.
Comparison half_against_one(Range range) {
    Image a = flat(2, 1, {0, 0, 0}), b = a;
    a.layers[0].pixels[0] = 1;
    b.layers[0].pixels[0] = 0.5f;
    a.range = b.range = range;
    return compare(a, b);
}

TEST(Comparison, GivesTheErrorsThatOneComputesByHand) {
    const Comparison scene = half_against_one(Range::scene);
    EXPECT_NEAR(scene.rmse, std::sqrt(0.25 / 6), 1e-9);
    EXPECT_NEAR(scene.relmse, 0.25 / (0.25 + 0.01) / 6, 1e-9);
    EXPECT_NEAR(scene.psnr, 10 * std::log10(0.25 * 6 / 0.25), 1e-9); // peak: the reference's 0.5
    EXPECT_EQ(scene.max_error, 0.5);
    EXPECT_EQ(scene.flip_kind, FlipKind::hdr);
    const Comparison display = half_against_one(Range::display);
    EXPECT_NEAR(display.psnr, 10 * std::log10(1 * 6 / 0.25), 1e-9); // peak: 1
    EXPECT_EQ(display.flip_kind, FlipKind::ldr);
    EXPECT_FALSE(display.tile_z.has_value());
}

TEST(Comparison, TakesTheSecondImageForTheReference) {
    const Image black = flat(4, 4, {0, 0, 0}), white = flat(4, 4, {1, 1, 1});
    EXPECT_NEAR(compare(white, black).relmse, 1 / 0.01, 1e-9);
    EXPECT_NEAR(compare(black, white).relmse, 1 / 1.01, 1e-9);
}

TEST(Comparison, FindsTheWorstPixel) {
    const Image a = flat(7, 5, {1, 1, 1});
    Image b = a;
    b.layers[0].pixels[4 * (3 * 7 + 2) + 1] = 4;
    b.layers[0].pixels[4 * (3 * 7 + 4) + 2] = -1;
    const Comparison comparison = compare(a, b);
    EXPECT_EQ(comparison.max_x, 2u);
    EXPECT_EQ(comparison.max_y, 3u);
    EXPECT_EQ(comparison.max_channel, 1u);
    EXPECT_EQ(comparison.max_error, 3);
}

TEST(Comparison, OfEqualImagesIsPerfect) {
    const Image image =
        make_image(30, 20, [](std::uint32_t x, std::uint32_t y) { return glm::vec3(x, y, x + y); });
    const Comparison comparison = compare(image, image);
    EXPECT_EQ(comparison.rmse, 0);
    EXPECT_EQ(comparison.relmse, 0);
    EXPECT_EQ(comparison.flip, 0);
    EXPECT_EQ(comparison.psnr, std::numeric_limits<double>::infinity());
}

TEST(Comparison, NamesTheFileAndPixelOfWhatIsNotFinite) {
    Image good = flat(5, 4, {1, 1, 1}), bad = good;
    bad.layers[0].pixels[4 * (2 * 5 + 3) + 1] = NAN;
    const std::string error =
        error_of([&] { compare(good, bad, {.test_name = "a.exr", .reference_name = "b.exr"}); });
    for (const char* part : {"b.exr", "(3, 2)", "G", "nan"})
        EXPECT_NE(error.find(part), std::string::npos) << error;
    EXPECT_EQ(error.find("a.exr"), std::string::npos) << error;
    for (Image* image : {&good, &bad}) image->add("variance", {"R", "G", "B"});
    bad.layers[0].pixels = good.layers[0].pixels;
    EXPECT_EQ(error_of([&] { compare(bad, good); }), "");
    bad.layers[1].pixels[3 * 19 + 2] = INFINITY;
    EXPECT_NE(error_of([&] { compare(bad, good); }).find("A: pixel (4, 3): variance.B"), std::string::npos);
}

TEST(Comparison, RefusesOtherSizesAndImagesWithoutColour) {
    const std::string sizes = error_of([] { compare(flat(4, 3, {0, 0, 0}), flat(4, 4, {0, 0, 0})); });
    EXPECT_NE(sizes.find("4 x 3"), std::string::npos) << sizes;
    EXPECT_NE(sizes.find("4 x 4"), std::string::npos) << sizes;
    Image depth{4, 4, {}, {}, Range::scene};
    depth.add("depth", {"Z"});
    EXPECT_NE(error_of([&] { compare(depth, depth); }).find("'depth'"), std::string::npos);
}

TEST(Verdict, BreaksOnTheLimitThatIsExceededAndSaysWhich) {
    const Comparison comparison = half_against_one(Range::scene); // RMSE 0.204, relMSE 0.160, max 0.5
    EXPECT_TRUE(judge(comparison, {.max_rmse = 0.21}).same);
    const Verdict rmse = judge(comparison, {.max_rmse = 0.20, .max_relmse = 0.17});
    EXPECT_FALSE(rmse.same);
    ASSERT_EQ(rmse.reasons.size(), 1u);
    EXPECT_EQ(rmse.reasons[0].substr(0, 5), "RMSE ");
    EXPECT_FALSE(judge(comparison, {.max_relmse = 0.15}).same);
    EXPECT_FALSE(judge(comparison, {.max_flip = comparison.flip * 0.99}).same);
    EXPECT_TRUE(judge(comparison, {.max_flip = comparison.flip}).same);
    EXPECT_FALSE(judge(comparison, {.max_error = 0.4}).same);
}

TEST(Verdict, WithoutLimitsOrVarianceDemandsEquality) {
    EXPECT_FALSE(judge(half_against_one(Range::scene), {}).same);
    const Image image = flat(3, 3, {1, 2, 3});
    EXPECT_TRUE(judge(compare(image, image), {}).same);
}

TEST(Verdict, LetsNoiseExcuseADifferenceThatItExplains) {
    Image a = flat(32, 32, {1, 1, 1}), b = flat(32, 32, {1.1f, 1.1f, 1.1f});
    for (Image* image : {&a, &b}) {
        image->add("variance", {"R", "G", "B"});
        for (float& variance : image->layers[1].pixels) variance = 25; // z of the whole: 0.1 * 32 / sqrt(50)
    }
    EXPECT_TRUE(judge(compare(a, b), {}).same);
    EXPECT_FALSE(judge(compare(a, b), {.max_rmse = 0.05}).same);
    for (Image* image : {&a, &b})
        for (float& variance : image->layers[1].pixels) variance = 0.01f; // 22.6
    const Verdict verdict = judge(compare(a, b), {});
    EXPECT_FALSE(verdict.same);
    EXPECT_EQ(verdict.reasons.size(), 2u); // the whole and its tiles; pixels differ by 0.7 deviations
    EXPECT_TRUE(judge(compare(a, b), {.z_scales = {ZScale::pixels}}).same);
}

TEST(HeatMap, HasThePublishedColoursInThePngFile) {
    const Folder folder;
    Comparison comparison;
    comparison.width = 256;
    comparison.height = 1;
    for (int i = 0; i < 256; ++i) comparison.flip_error.push_back(static_cast<float>(i) / 255);
    write_image(folder / "diff.png", heat_map(comparison));
    const DecodedImage image = decode_rgba8(read_file(folder / "diff.png"), "diff.png");
    // Entries of matplotlib's table (_cm_listed.py, CC0).
    const std::pair<std::size_t, glm::vec3> published[] = {{0, {0.001462f, 0.000466f, 0.013866f}},
                                                           {64, {0.316654f, 0.071690f, 0.485380f}},
                                                           {128, {0.716387f, 0.214982f, 0.475290f}},
                                                           {255, {0.987053f, 0.991438f, 0.749504f}}};
    for (const auto& [entry, color] : published)
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(image.rgba[4 * entry + static_cast<std::size_t>(c)], 255 * color[c], 3) << entry;
}

} // namespace
} // namespace ajar::test
