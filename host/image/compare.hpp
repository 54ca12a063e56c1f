// How two images of equal size differ: mean errors, FLIP, and, where both carry variance, whether noise
// explains it.
#pragma once

#include "image/flip.hpp"
#include "image/image.hpp"
#include "image/ztest.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace ajar {

// automatic: HDR-FLIP of two images of radiance, else LDR-FLIP.
enum class FlipKind : std::uint8_t { automatic, ldr, hdr };

struct CompareOptions {
    std::string test_name = "A"; // for errors: the files
    std::string reference_name = "B";
    FlipKind flip = FlipKind::automatic;
    float pixels_per_degree = DEFAULT_PIXELS_PER_DEGREE;
    std::uint32_t tile = 16;    // pixels, side of the z-test's tiles
    double significance = 1e-4; // chance to call two renders of one scene different
};

struct Comparison {
    std::uint32_t width = 0, height = 0;
    // Over R, G and B, linear.
    double rmse = 0;
    double relmse = 0; // mean of (a - b)^2 / (b^2 + 0.01), b the reference
    double psnr =
        0; // dB; the peak is 1 for display images, else the reference's largest value; infinite if equal
    double max_error = 0;
    std::uint32_t max_x = 0, max_y = 0, max_channel = 0; // where
    FlipKind flip_kind = FlipKind::ldr;                  // which one was taken
    double flip = 0;                                     // mean
    Plane flip_error;                                    // per pixel
    double significance = 0;
    // Absent without variance in both. The whole image, tiles, and single pixels: see judge().
    std::optional<ZTest> image_z, tile_z, pixel_z;
};

// Throws Error: sizes differ, a layer is missing, a value that is not finite (with file and pixel).
Comparison compare(const Image& test, const Image& reference, const CompareOptions& options = {});

enum class ZScale : std::uint8_t { image, tiles, pixels };

// What still counts as the same. With few samples a pixel's mean is far from normal in the tails that a
// correction over a million tests looks at, so that single pixels reject too often; tiles and the whole image
// average that out, and are what judges unless single pixels are asked for.
struct Limits {
    std::optional<double> max_flip{}, max_rmse{}, max_relmse{}, max_error{};
    std::vector<ZScale> z_scales{ZScale::image, ZScale::tiles}; // empty: noise is no excuse and no evidence
};

struct Verdict {
    bool same = true;
    std::vector<std::string> reasons; // one line for each limit that is broken
};

// Every limit that is set must hold, and the z-tests (at Comparison::significance for the chosen scales
// together). With no limit and no z-test the images must be equal.
Verdict judge(const Comparison& comparison, const Limits& limits);

// The FLIP error in the colours of magma, from black (0) to pale yellow (1); to be written as PNG with the
// operator "linear".
Image heat_map(const Comparison& comparison);

} // namespace ajar
