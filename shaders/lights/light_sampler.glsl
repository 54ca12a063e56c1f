// The switch over light samplers (SPEC_LIGHT_SAMPLER). A sampler may look at the shaded point and its normal;
// one that does must use the same point and normal in pmf for MIS.
#ifndef AJAR_LIGHT_SAMPLER_GLSL
#define AJAR_LIGHT_SAMPLER_GLSL
#include "sampler_power.glsl"
#include "sampler_uniform.glsl"

LightPick light_sampler_pick(vec3 point, vec3 normal, float u) {
    if (!has_feature(FEATURE_ANY_LIGHT)) return LightPick(0u, 0.0, u); // the tables are empty
    if (LIGHT_SAMPLER == LIGHT_SAMPLER_UNIFORM) return sampler_uniform_pick(u);
    return sampler_power_pick(u);
}

// Probability that light_sampler_pick gives `light` at that point.
float light_sampler_pmf(vec3 point, vec3 normal, uint light) {
    if (LIGHT_SAMPLER == LIGHT_SAMPLER_UNIFORM) return sampler_uniform_pmf();
    return sampler_power_pmf(light);
}

#endif
