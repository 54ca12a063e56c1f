// The film: exact sums in fixed point, so that the order of samples does not matter and disjoint ranges merge
// exactly.
#ifndef AJAR_FILM_GLSL_H
#define AJAR_FILM_GLSL_H
#include "dual.glsl.h"
DUAL_BEGIN

// A sample above FILM_MAX_SAMPLE is cut there and counted in Diagnostics.
const float FILM_MAX_SAMPLE = 16777216.0f; // 2^24

// sum: 64 bits in units of 2^-28; square: 96 bits in units of 2^-44. Words low to high, per channel R, G, B.
// A million samples at 2^16 stay below either's end; 2^-28 is a hundredth of an 8-bit step at an exposure of
// +18 EV.
struct FilmPixel {
    uint count;     // samples
    uint sum[6];
    uint square[9];
};
DUAL_SIZE(FilmPixel, 64);

const uint AOV_CHANNELS = 13; // albedo 3, normal 3, position 3, depth 1, emission 3

// First-hit attributes: means over samples that hit something; signed 64-bit sums in units of 2^-32.
struct AovPixel {
    uint sum[26];     // AOV_CHANNELS x 2, low word first, two's complement
    uint hits;        // samples that hit a surface
    uint object_id;   // of sample 0: Scene::instances index + 1, 0 where nothing is hit
    uint material_id; // of sample 0: Scene::materials index + 1
    uint pad[3];
};
DUAL_SIZE(AovPixel, 128);

// What must never happen, counted; the first of each kind is recorded.
struct Diagnostics {
    uint invalid_count;   // samples that were NaN, Inf or negative: dropped (counted as black)
    uint invalid_pixel;   // x | y << 16
    uint invalid_sample;
    uint invalid_bounce;
    uint saturated_count; // samples cut at FILM_MAX_SAMPLE
    uint assert_count;    // AJAR_DEBUG: failed ASSERTs
    uint assert_line;
    uint assert_thread;
};
DUAL_SIZE(Diagnostics, 32);
DUAL_PTR(AovPixel);
DUAL_PTR(Diagnostics);

DUAL_END
#endif
