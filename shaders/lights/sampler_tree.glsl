// Samplers tree and visibility: pick a light by what it may bring to the point, the second one times the
// visibility that the point's cell learned. Lights that are somewhere through the light tree, those
// that are nowhere (directional, environment) in proportion to their irradiance. Which of the two groups is
// decided by what each may bring; either keeps a tenth, for these are estimates.
#ifndef AJAR_SAMPLER_TREE_GLSL
#define AJAR_SAMPLER_TREE_GLSL
#include "light_tree.glsl"

const uint FEATURE_DISTANT_LIGHTS = FEATURE_PUNCTUAL_LIGHTS | FEATURE_SOFT_LIGHTS |
                                    FEATURE_ENVIRONMENT_MAP | FEATURE_CONSTANT_ENVIRONMENT;
const float SAMPLER_TREE_LEAST_SHARE = 0.1;

// Probability of the distant lights.
float sampler_tree_distant_share(LightReceiver at, uint cell) {
    if (!has_feature(FEATURE_DISTANT_LIGHTS)) return 0.0;
    float distant = frame.distant_irradiance;
    LightReceiver plain = at; // irradiance against irradiance
    plain.specular = 0.0;
    float near = light_tree_importance_of_all(plain);
    if (LIGHT_SAMPLER_LEARNS) {
        const vec2 seen = visibility_of_all(cell);
        distant *= seen.x;
        near *= seen.y;
    }
    const float share = clamp(distant / (distant + near), SAMPLER_TREE_LEAST_SHARE,
                              1.0 - SAMPLER_TREE_LEAST_SHARE);
    const float alone = near > 0.0 ? share : 1.0;
    return distant > 0.0 ? alone : 0.0;
}

// Share of a light among the distant ones; 0 for one that is somewhere.
float sampler_tree_distant_pmf(uint light) {
    const uint kind = fetch_light(light * LIGHT_TEXELS).w & LIGHT_KIND_MASK;
    const bool distant = kind == LIGHT_DIRECTIONAL || kind == LIGHT_ENVIRONMENT || kind == LIGHT_SUN;
    return distant ? uintBitsToFloat(fetch_light(light * LIGHT_TEXELS + 2u).x) : 0.0;
}

LightPick sampler_tree_pick_distant(float u) {
    LightPick pick = light_pick_by_alias(frame.distant_first, frame.distant_slots, u);
    pick.pmf = sampler_tree_distant_pmf(pick.light);
    return pick;
}

// Where there is nothing to look up, the cell is not worked out.
uint sampler_tree_cell(LightReceiver at) {
    return LIGHT_SAMPLER_LEARNS ? visibility_cell(at.point, at.normal) : 0u;
}

LightPick sampler_tree_pick(LightReceiver at, float u) {
    const uint cell = sampler_tree_cell(at);
    const float share = sampler_tree_distant_share(at, cell);
    const bool distant = u < share;
    const float mass = distant ? share : 1.0 - share;
    const float rest = min((distant ? u : u - share) / mass, LIGHT_PICK_BELOW_ONE);
    LightPick pick = LightPick(0u, 0.0, rest, 0.0);
    if (has_feature(FEATURE_DISTANT_LIGHTS)) {
        if (distant) pick = sampler_tree_pick_distant(rest);
        pick.pmf *= share;
    }
    if (frame.tree_lights != 0u && !distant) {
        const LightTreeWay way = light_tree_descend(at, cell, rest, 0u, false);
        pick = LightPick(way.light, (1.0 - share) * way.pmf, way.u, way.step);
    }
    pick.step /= mass;
    return pick;
}

float sampler_tree_pmf(LightReceiver at, uint light) {
    const uint cell = sampler_tree_cell(at);
    const float share = sampler_tree_distant_share(at, cell);
    const uint trail = frame.tree_lights != 0u ? light_tree_trail(light) : NO_TRAIL;
    float pmf = 0.0;
    if (trail != NO_TRAIL)
        pmf = (1.0 - share) * light_tree_descend(at, cell, 0.0, trail, true).pmf;
    if (has_feature(FEATURE_DISTANT_LIGHTS)) pmf += share * sampler_tree_distant_pmf(light);
    return pmf;
}

#endif
