// Picks every light with the same probability: the baseline that other samplers are compared with.
#ifndef AJAR_SAMPLER_UNIFORM_GLSL
#define AJAR_SAMPLER_UNIFORM_GLSL
#include "light_pick.glsl"

float sampler_uniform_pmf() { return 1.0 / float(max(frame.light_count, 1u)); }

LightPick sampler_uniform_pick(float u) {
    const float scaled = u * float(frame.light_count);
    // The product may round up to the count.
    const float index = min(floor(scaled), float(max(frame.light_count, 1u) - 1u));
    return LightPick(uint(int(index)), sampler_uniform_pmf(), min(scaled - index, LIGHT_PICK_BELOW_ONE));
}

#endif
