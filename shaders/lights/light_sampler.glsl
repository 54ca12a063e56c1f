// The switch over light samplers (SPEC_LIGHT_SAMPLER). A sampler may look at the vertex that a light is
// picked for; what it sees of it must reach pmf as it reached pick, to the last bit (receiver.glsl).
#ifndef AJAR_LIGHT_SAMPLER_GLSL
#define AJAR_LIGHT_SAMPLER_GLSL
#include "sampler_power.glsl"
#include "sampler_tree.glsl"
#include "sampler_uniform.glsl"

// Whether it does look.
const bool LIGHT_SAMPLER_LOOKS = LIGHT_SAMPLER == LIGHT_SAMPLER_TREE || LIGHT_SAMPLER_LEARNS;

LightPick light_sampler_pick(LightReceiver at, float u) {
    if (!has_feature(FEATURE_ANY_LIGHT)) return LightPick(0u, 0.0, u, 0.0); // the tables are empty
    if (LIGHT_SAMPLER == LIGHT_SAMPLER_UNIFORM) return sampler_uniform_pick(u);
    if (LIGHT_SAMPLER_LOOKS) return sampler_tree_pick(at, u);
    return sampler_power_pick(u);
}

// Probability that light_sampler_pick gives `light` at that point.
float light_sampler_pmf(LightReceiver at, uint light) {
    if (LIGHT_SAMPLER == LIGHT_SAMPLER_UNIFORM) return sampler_uniform_pmf();
    if (LIGHT_SAMPLER_LOOKS) return sampler_tree_pmf(at, light);
    return sampler_power_pmf(light);
}

#endif
