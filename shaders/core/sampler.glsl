// The switch over samplers (SPEC_SAMPLER): where a path's random numbers come from. Each is a pure function
// of (seed, pixel, sample, dimension), so that nothing is stored and no order matters.
#ifndef AJAR_SAMPLER_GLSL
#define AJAR_SAMPLER_GLSL
#include "../shared/dimensions.glsl.h"
#include "rng.glsl"
#include "sampler_blue_noise.glsl"
#include "sampler_sobol.glsl"
#include "variants.glsl"

struct Sampler {
    uint index; // Sobol: of the sample in its sequence, its bits reversed
    uint seed;  // of the sequence
};

// `ordinal`: of the pixel along the film's Z-order curve. `samples_log2`: the blue-noise sequence has
// 2^samples_log2 samples a pixel, at most 2^31, of which sample_index is one; others have no such bound.
Sampler sampler_begin(uint seed, uint ordinal, uint sample_index, uint samples_log2) {
    if (SAMPLER == SAMPLER_INDEPENDENT)
        return Sampler(0u, rng_combine(rng_combine(seed, ordinal), sample_index));
    if (SAMPLER == SAMPLER_BLUE_NOISE) {
        const uvec2 index_seed = sampler_blue_noise_index(seed, ordinal, sample_index, samples_log2);
        return Sampler(index_seed.x, index_seed.y);
    }
    return Sampler(bitfieldReverse(sample_index), rng_combine(seed, ordinal));
}

// First dimension of a bounce's block; add DIM_*.
uint sampler_bounce(uint bounce) { return DIM_BOUNCE_FIRST + bounce * DIM_PER_BOUNCE; }

// Whose sequence and which dimension: distinct hashes in all likelihood.
uint sampler_key(Sampler s, uint dimension) { return rng_hash(s.seed + dimension * 0x9e3779b9u); }

float sampler_1d(Sampler s, uint dimension) {
    const uint key = sampler_key(s, dimension);
    return SAMPLER == SAMPLER_INDEPENDENT ? rng_to_float(key) : sampler_sobol_1d(s.index, key);
}

// `dimension` and the next, stratified together unless the sampler is independent.
vec2 sampler_2d(Sampler s, uint dimension) {
    const uint key = sampler_key(s, dimension);
    if (SAMPLER == SAMPLER_INDEPENDENT)
        return vec2(rng_to_float(key), rng_to_float(sampler_key(s, dimension + 1u)));
    return sampler_sobol_2d(s.index, key);
}

#endif
