// Picks every light with the same probability: the baseline that other samplers are compared with. In
// integers, as u * count rounded to a float would leave the rest of u on a grid of its own.
#ifndef AJAR_SAMPLER_UNIFORM_GLSL
#define AJAR_SAMPLER_UNIFORM_GLSL
#include "light_pick.glsl"

float sampler_uniform_pmf() { return 1.0 / float(max(frame.light_count, 1u)); }

LightPick sampler_uniform_pick(float u) {
    // u has 24 digits; as a number of 32 its product with the count is the light, and the rest below.
    uint light;
    uint rest;
    umulExtended(uint(int(u * 16777216.0)) << 8, frame.light_count, light, rest);
    return LightPick(light, sampler_uniform_pmf(), float(int(rest >> 8)) * LIGHT_PICK_STEP,
                     LIGHT_PICK_STEP * float(frame.light_count));
}

#endif
