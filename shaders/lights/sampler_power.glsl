// Picks a light in proportion to its power, by an alias table in integers of 2^-24: u comes in such steps, so
// power_pmf is the very probability of being picked.
#ifndef AJAR_SAMPLER_POWER_GLSL
#define AJAR_SAMPLER_POWER_GLSL
#include "light_pick.glsl"

float sampler_power_pmf(uint light) { return uintBitsToFloat(fetch_light(light * LIGHT_TEXELS + 2u).w); }

LightPick sampler_power_pick(float u) {
    // Smallest power of two >= light_count, as AliasTable lays it out (findMSB(0) is -1).
    const uint slots = 1u << uint(findMSB(max(frame.light_count, 1u) - 1u) + 1);
    LightPick pick = light_pick_by_alias(frame.alias_first, slots, u);
    pick.pmf = sampler_power_pmf(pick.light);
    return pick;
}

#endif
