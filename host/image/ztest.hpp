// Are two noisy images of the same expectation? Both carry a layer "variance" (of each pixel's mean). Over a
// block of pixels D = sum(a - b) has variance V = sum(va + vb), so z = D / sqrt(V) is standard normal if the
// pixels are independent and many samples lie behind a block. Every block and channel is a test; Sidak's
// correction (Zbynek Sidak, 1967) makes one verdict of them.
#pragma once

#include "image/image.hpp"

#include <cstdint>

namespace ajar {

struct BlockSize {
    std::uint32_t width = 1; // pixels; at the right and lower border blocks are cut
    std::uint32_t height = 1;
};

struct ZTest {
    std::uint64_t tests = 0;    // blocks times R, G, B
    std::uint64_t rejected = 0; // tests below the level that Sidak's correction gives each
    double p = 1;               // the smallest two-sided p-value
    double corrected_p = 1;     // chance that any of the tests has so small a p by noise alone
    double z = 0;               // of that test; positive: a is brighter
    std::uint32_t x = 0, y = 0; // the first pixel of its block
    std::uint32_t channel = 0;
};

// 2 (1 - Phi(|z|)).
double two_sided_p(double z);

// 1 - (1 - p)^tests, exact for tiny p.
double sidak(double p, std::uint64_t tests);

// The level for each of `tests` that makes `significance` for all: 1 - (1 - significance)^(1 / tests).
double sidak_level(double significance, std::uint64_t tests);

// Both images have the beauty layer and "variance" with three channels, finite and of equal size. What the
// files' floats cannot hold (Layer::rounding) is no difference: where a pixel's noise is smaller than its
// rounding the rounding is taken off |D|, since equal pixels round alike; elsewhere it counts as noise.
ZTest z_test(const Image& a, const Image& b, BlockSize block, double significance);

} // namespace ajar
