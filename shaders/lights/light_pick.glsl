// What every light sampler returns.
#ifndef AJAR_LIGHT_PICK_GLSL
#define AJAR_LIGHT_PICK_GLSL
#include "../core/tables.glsl"
#include "../shared/light.glsl.h"

struct LightPick {
    uint light; // index of the LightRecord
    float pmf;  // probability of having picked it; 0: no light, skip it
    float u;    // what is left of u: uniform again, but with only the digits that the choice did not use
    float step; // of those digits: what lies between two values of u
};

const uint FEATURE_ANY_LIGHT = FEATURE_EMISSIVE_TRIANGLES | FEATURE_PUNCTUAL_LIGHTS |
                               FEATURE_ENVIRONMENT_MAP | FEATURE_CONSTANT_ENVIRONMENT | FEATURE_SOFT_LIGHTS;
const float LIGHT_PICK_BELOW_ONE = 0.99999994; // 1 - 2^-24, the largest u
const float LIGHT_PICK_STEP = 5.9604644775390625e-8; // 2^-24, in which u comes

// What is left of u with the digits that it lacks filled in from `digits`, in [0, 1): fit to pick a place on
// the light, which is then stratified together with the choice.
float light_pick_rest(LightPick pick, float digits) {
    return min(pick.u + pick.step * digits, LIGHT_PICK_BELOW_ONE);
}

// By the alias method (Walker 1977; Vose 1991): from a table of `slots` AliasEntries, a power of two, that
// begins at texel `first`. Slot and remainder of u are exact. The probability is for the caller to state.
LightPick light_pick_by_alias(uint first, uint slots, float u) {
    const float scaled = u * float(slots);
    const float slot = floor(scaled);
    const float rest = scaled - slot;
    const uvec4 entry = fetch_light(first + uint(int(slot)));
    const float keep = uintBitsToFloat(entry.x);
    const bool kept = rest < keep;
    const float mass = kept ? keep : 1.0 - keep;
    LightPick pick;
    pick.light = kept ? entry.z : entry.y;
    pick.pmf = 0.0;
    pick.u = min((kept ? rest : rest - keep) / mass, LIGHT_PICK_BELOW_ONE);
    pick.step = LIGHT_PICK_STEP * float(slots) / mass;
    return pick;
}

#endif
