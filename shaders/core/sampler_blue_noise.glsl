// Whose point a sample is when the whole picture shares one scrambled Sobol sequence: neighbours on the curve
// of pixels take neighbouring blocks of it, and what one pixel's error lacks its neighbours' have, so that
// errors cancel where a picture is blurred or looked at. After Ahmed and Wonka 2020, "Screen-Space Blue-Noise
// Diffusion of Monte Carlo Sampling Error via Hierarchical Ordering of Pixels".
#ifndef AJAR_SAMPLER_BLUE_NOISE_GLSL
#define AJAR_SAMPLER_BLUE_NOISE_GLSL
#include "sampler_sobol.glsl"

// A Z-order curve, bits reversed, that crosses each square of four row by row or column by column as a hash
// of the squares around it says: else errors would cancel along rows better than along columns. Flips of the
// two halves come with each dimension's own shuffle.
uint sampler_blue_noise_curve(uint ordinal, uint seed) {
    const uint reversed = bitfieldReverse(ordinal);
    // Reversed, the upper bit of a base-4 digit has an even place, and a scramble sees only digits before it.
    const uint turned = (sampler_scramble(reversed, seed) ^ reversed) & 0x55555555u;
    const uint swapped = (reversed ^ (reversed >> 1)) & turned;
    return reversed ^ swapped ^ (swapped << 1);
}

// The reversed index of a sample in the picture's sequence, and the sequence's seed (y). Each pixel has
// 2^samples_log2 consecutive points. Of pixels so many that the index has no bits left for, each run of the
// curve that fits has a sequence of its own.
uvec2 sampler_blue_noise_index(uint seed, uint ordinal, uint sample_index, uint samples_log2) {
    const uint curve = sampler_blue_noise_curve(ordinal, rng_hash(seed));
    const uint run = curve & ((1u << samples_log2) - 1u);
    return uvec2(bitfieldReverse(sample_index) | (curve >> samples_log2), rng_combine(seed, run));
}

#endif
