// Integer hashes: the source of all randomness, so that a number is a pure function of where it is used.
// Finaliser: Wellons 2018, "Prospecting for Hash Functions", in TheIronBorn's later constants (bias 0.107).
#ifndef AJAR_RNG_GLSL
#define AJAR_RNG_GLSL
#extension GL_GOOGLE_include_directive : require

// A bijection of 32 bits: every bit of x flips every bit of the result with a probability near one half.
uint rng_hash(uint x) {
    x ^= x >> 16;
    x *= 0x21f0aaadu;
    x ^= x >> 15;
    x *= 0x735a2d97u;
    return x ^ (x >> 15);
}

// A hash of the ordered pair; fold longer keys from the left.
uint rng_combine(uint seed, uint value) {
    return rng_hash(seed * 0x9e3779b9u ^ rng_hash(value + 0x85ebca6bu));
}

// [0, 1) in steps of 2^-24: 1 - 2^-24 at most. By way of int, since lanes convert signed numbers in one
// instruction.
float rng_to_float(uint bits) { return float(int(bits >> 8)) * 5.9604644775390625e-8; }

float rng_hash_to_float(uint key) { return rng_to_float(rng_hash(key)); }

// The coin of stochastic alpha: the same ray and triangle always see the same number. `salt`: a hash's bits.
float rng_salted_float(uint salt, uint triangle, uint instance) {
    return rng_to_float(rng_hash(rng_hash(triangle ^ salt) + instance * 0x9e3779b9u));
}

#endif
