// Owen-scrambled Sobol points as a pure function of (seed, pixel, sample, dimension), after Burley 2020,
// "Practical Hash-based Owen Scrambling": each pair of dimensions takes the first two Sobol dimensions, its
// own nested shuffle of the sample index and its own nested scrambles. Scrambling hash: Laine and Karras 2011
// in Vegdahl's form and constants ("Building a Better LK Hash", 2021). Any 2^m-aligned block of samples of a
// pair is a (0, m, 2)-net.
#ifndef AJAR_SAMPLER_SOBOL_GLSL
#define AJAR_SAMPLER_SOBOL_GLSL
#include "rng.glsl"

// Flips each bit by a hash of the seed and the bits below it: Owen's scramble of the reversed number.
uint sampler_scramble(uint x, uint seed) {
    x ^= x * 0x3d20adeau;
    x += seed;
    x *= (seed >> 16) | 1u;
    x ^= x * 0x05526c56u;
    return x ^ (x * 0x53a22864u);
}

// The second Sobol dimension of index j, its bits reversed. Its matrix is Pascal's triangle modulo 2, where
// entry (k, r) is 1 when r's bits are a subset of k's (Lucas): so bit r is the sum of all j's bits k whose
// number contains r, a sum over supersets that one step for each bit of the number makes.
uint sampler_sobol1_reversed(uint j) {
    j ^= (j >> 1) & 0x55555555u;
    j ^= (j >> 2) & 0x33333333u;
    j ^= (j >> 4) & 0x0f0f0f0fu;
    j ^= (j >> 8) & 0x00ff00ffu;
    return j ^ (j >> 16);
}

// `index`: of the sample, its bits reversed; `key`: a hash of whose sequence it is, and of the dimension. The
// first Sobol dimension of j is j reversed. All steps are laid out so that three reversals are left in a
// pair.
float sampler_sobol_1d(uint index, uint key) {
    const uint j = bitfieldReverse(sampler_scramble(index, key));
    return rng_to_float(bitfieldReverse(sampler_scramble(j, rng_hash(key))));
}

vec2 sampler_sobol_2d(uint index, uint key) {
    const uint key_x = rng_hash(key);
    const uint key_y = rng_hash(key_x);
    const uint j = bitfieldReverse(sampler_scramble(index, key));
    const uint x = bitfieldReverse(sampler_scramble(j, key_x));
    const uint y = bitfieldReverse(sampler_scramble(sampler_sobol1_reversed(j), key_y));
    return vec2(rng_to_float(x), rng_to_float(y));
}

#endif
