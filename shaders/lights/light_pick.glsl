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

#endif
