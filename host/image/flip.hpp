// FLIP, the error that a person sees when two images alternate at one place: LDR-FLIP (Andersson, Nilsson,
// Akenine-Moeller, Oskarsson, Astrom, Fairchild, "FLIP: A Difference Evaluator for Alternating Images", HPG
// 2020) and HDR-FLIP, its maximum over exposures (Andersson, Nilsson, Shirley, Akenine-Moeller, "Visualizing
// Errors in Rendered High Dynamic Range Images", Eurographics 2021). 0: no difference; 1: the largest.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace ajar {

using Plane = std::vector<float>; // width * height, row 0 at the top

struct ColorPlanes {
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::array<Plane, 3> channel; // R, G, B of Rec. 709, linear
};

// A 0.7 m wide monitor of 3840 pixels, seen from 0.7 m: the papers' viewing condition.
inline constexpr float DEFAULT_PIXELS_PER_DEGREE = 67;

// Per-pixel error of display-linear images; values outside [0, 1] are cut off.
Plane flip_ldr(const ColorPlanes& reference, const ColorPlanes& test, float pixels_per_degree);

// Per-pixel error of radiance; negative values are cut off. Exposures and tone curve (ACES) as the paper
// chooses them.
Plane flip_hdr(const ColorPlanes& reference, const ColorPlanes& test, float pixels_per_degree);

struct ExposureRange {
    float start = 0, stop = 0; // EV
    int count = 1;
};

// From the exposure that puts the reference's maximal luminance at 85 % of the display's to the one that puts
// its median there, about one stop apart. A black reference has the one exposure 0.
ExposureRange flip_exposures(const ColorPlanes& reference);

} // namespace ajar
