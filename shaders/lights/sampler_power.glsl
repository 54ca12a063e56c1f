// Picks a light in proportion to its power, by the alias method (Walker 1977; Vose 1991) over 2^k slots in
// integers of 2^-24: u comes in such steps, so slot and remainder are exact and power_pmf is the very
// probability of being picked.
#ifndef AJAR_SAMPLER_POWER_GLSL
#define AJAR_SAMPLER_POWER_GLSL
#include "light_pick.glsl"

float sampler_power_pmf(uint light) { return uintBitsToFloat(fetch_light(light * LIGHT_TEXELS + 2u).w); }

LightPick sampler_power_pick(float u) {
    // Smallest power of two >= light_count, as AliasTable lays it out (findMSB(0) is -1).
    const uint slots = 1u << uint(findMSB(max(frame.light_count, 1u) - 1u) + 1);
    const float scaled = u * float(slots);
    const float slot = floor(scaled);
    const float rest = scaled - slot;
    const uvec4 entry = fetch_light(frame.alias_first + uint(int(slot)));
    const float keep = uintBitsToFloat(entry.x);
    const bool kept = rest < keep;
    LightPick pick;
    pick.light = kept ? uint(int(slot)) : entry.y;
    pick.pmf = sampler_power_pmf(pick.light);
    const float mass = kept ? keep : 1.0 - keep;
    pick.u = min((kept ? rest : rest - keep) / mass, LIGHT_PICK_BELOW_ONE);
    pick.step = LIGHT_PICK_STEP * float(slots) / mass;
    return pick;
}

#endif
