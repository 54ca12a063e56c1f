// The switch over light samplers (SPEC_LIGHT_SAMPLER). A sampler may look at the shaded point and its normal;
// one that does must use the same point and normal in pmf for MIS.
#ifndef AJAR_LIGHT_SAMPLER_GLSL
#define AJAR_LIGHT_SAMPLER_GLSL
#include "sampler_power.glsl"
#include "sampler_tree.glsl"
#include "sampler_uniform.glsl"

// Whether it does look: then the normal must reach pmf as it reached pick, to the last bit.
const bool LIGHT_SAMPLER_LOOKS = LIGHT_SAMPLER == LIGHT_SAMPLER_TREE || LIGHT_SAMPLER_LEARNS;

// A vertex's normal as light samplers see it, there and when its path meets a light: as it is kept till then.
vec3 light_sampler_normal(vec3 ng) {
    return LIGHT_SAMPLER_LOOKS ? octahedral_decode(octahedral_encode(ng)) : ng;
}

LightPick light_sampler_pick(vec3 point, vec3 normal, float u) {
    if (!has_feature(FEATURE_ANY_LIGHT)) return LightPick(0u, 0.0, u, 0.0); // the tables are empty
    if (LIGHT_SAMPLER == LIGHT_SAMPLER_UNIFORM) return sampler_uniform_pick(u);
    if (LIGHT_SAMPLER_LOOKS) return sampler_tree_pick(point, normal, u);
    return sampler_power_pick(u);
}

// Probability that light_sampler_pick gives `light` at that point.
float light_sampler_pmf(vec3 point, vec3 normal, uint light) {
    if (LIGHT_SAMPLER == LIGHT_SAMPLER_UNIFORM) return sampler_uniform_pmf();
    if (LIGHT_SAMPLER_LOOKS) return sampler_tree_pmf(point, normal, light);
    return sampler_power_pmf(light);
}

#endif
