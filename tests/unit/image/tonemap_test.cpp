// The tone-mapping operators against published values, and what all of them owe: order, bounds, black is
// black.
#include "folder.hpp"
#include "image/srgb.hpp"
#include "image/tonemap.hpp"

#include <cmath>

namespace ajar::test {
namespace {

TEST(Tonemap, EveryOperatorRisesWithGreyFromBlackAndStaysInRange) {
    for (const TonemapOperator& op : tonemap_operators()) {
        EXPECT_LT(op.apply(glm::vec3(0)).x, 1e-3f) << op.name;
        float before = -1;
        for (float stops = -12; stops <= 20; stops += 0.125f) {
            const glm::vec3 shown = op.apply(glm::vec3(std::exp2(stops)));
            for (int c = 0; c < 3; ++c) {
                ASSERT_GE(shown[c], 0) << op.name << " at " << stops;
                ASSERT_LE(shown[c], 1) << op.name << " at " << stops;
            }
            ASSERT_GE(shown.x, before - 2e-3f)
                << op.name << " at " << stops; // AgX's polynomial dips at both ends
            before = shown.x;
        }
        EXPECT_GT(before, 0.95f) << op.name;
    }
}

TEST(Tonemap, NeutralKeepsBaseColoursAndCompressesAsPublished) {
    const auto neutral = find_tonemap("neutral").apply;
    // Below the shoulder only F90 = 0.04 is taken off each channel (Khronos PBR Neutral, 2024).
    const glm::vec3 base = neutral({0.7f, 0.3f, 0.1f});
    EXPECT_NEAR(base.x, 0.66f, 1e-6f);
    EXPECT_NEAR(base.y, 0.26f, 1e-6f);
    EXPECT_NEAR(base.z, 0.06f, 1e-6f);
    // A dark channel x loses x - 6.25 x^2 from all: with x = 0.04, 0.03.
    EXPECT_NEAR(neutral({0.5f, 0.5f, 0.04f}).x, 0.47f, 1e-6f);
    // Grey 1.04 has peak 1: 1 - 0.24^2 / (1 + 0.24 - 0.76) = 0.88.
    EXPECT_NEAR(neutral(glm::vec3(1.04f)).x, 0.88f, 1e-5f);
}

TEST(Tonemap, AcesFollowsHillsCurveForGrey) {
    // Both matrices' rows sum to 1 within 2e-5, so grey x becomes the rational curve of x.
    const auto aces = find_tonemap("aces").apply;
    for (const double x : {0.05, 0.18, 1.0, 4.0}) {
        const double curve =
            (x * (x + 0.0245786) - 0.000090537) / (x * (0.983729 * x + 0.4329510) + 0.238081);
        EXPECT_NEAR(aces(glm::vec3(static_cast<float>(x))).y, curve, 1e-4) << x;
    }
}

TEST(Tonemap, AgxPutsMiddleGreyWhereItsSigmoidPivots) {
    // Sobotka's sigmoid passes through (10 / 16.5, 0.5) where the log2 encoding is of 0.18: encoded mid grey
    // is 0.5.
    const float shown = find_tonemap("agx").apply(glm::vec3(0.18f)).y;
    EXPECT_NEAR(std::pow(shown, 1 / 2.2f), 0.5f, 0.01f);
    // A saturated bright colour fades towards white: its weakest channel rises.
    const glm::vec3 red = find_tonemap("agx").apply({16, 0, 0});
    EXPECT_GT(red.y, 0.1f);
    EXPECT_GT(red.x, red.y);
}

TEST(Tonemap, ExposureIsInStops) {
    Tonemap tonemap;
    tonemap.exposure = -2;
    EXPECT_NEAR(tonemap({1, 2, 4}).x, srgb_encode(0.25f), 1e-6f);
    EXPECT_NEAR(tonemap({1, 2, 4}).y, srgb_encode(0.5f), 1e-6f);
    EXPECT_NEAR(tonemap({1, 2, 4}).z, 1, 1e-6f);
}

TEST(Tonemap, TurnsAnythingIntoAColour) {
    for (const TonemapOperator& op : tonemap_operators())
        for (const float bad : {NAN, INFINITY, -INFINITY, -1.0f, 3e38f, 1e-44f}) {
            const glm::vec3 shown = Tonemap{&op, 0}({bad, 0.5f, bad});
            for (int c = 0; c < 3; ++c) {
                EXPECT_GE(shown[c], 0) << op.name << " of " << bad;
                EXPECT_LE(shown[c], 1) << op.name << " of " << bad;
            }
        }
}

TEST(Tonemap, ListsTheNamesWhenOneIsUnknown) {
    const std::string error = error_of([] { find_tonemap("filmic"); });
    for (const char* name : {"filmic", "linear", "agx", "aces", "neutral"})
        EXPECT_NE(error.find(name), std::string::npos) << error;
    EXPECT_STREQ(Tonemap{}.op->name, "linear");
}

TEST(Srgb, EncodesAndDecodesInverselyAndMeetsTheStandard) {
    for (int i = 0; i <= 255; ++i) {
        const float encoded = static_cast<float>(i) / 255;
        ASSERT_NEAR(srgb_encode(srgb_decode(encoded)), encoded, 1e-6f);
    }
    EXPECT_NEAR(srgb_encode(0.5f), 0.7353569f, 1e-6f); // 1.055 * 0.5^(1/2.4) - 0.055
    EXPECT_NEAR(srgb_decode(0.04045f), 0.0031308f, 1e-6f);
}

} // namespace
} // namespace ajar::test
