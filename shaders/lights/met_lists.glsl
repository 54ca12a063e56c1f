// Light that the paths of a segment met, added to their radiances.
#ifndef AJAR_MET_LISTS_GLSL
#define AJAR_MET_LISTS_GLSL
#include "../core/hit_lists.glsl"
#include "met.glsl"

// The lists that it takes. Soft lights may lie before any surface, and behind all of them.
uint met_lists_wanted() {
    uint wanted = HIT_LISTS_EMITTING;
    if (has_feature(FEATURE_SOFT_LIGHTS)) wanted |= HIT_LISTS_ALL_EMIT;
    if (has_feature(FEATURE_ANY_ENVIRONMENT | FEATURE_SOFT_LIGHTS)) wanted |= HIT_LISTS_ESCAPED;
    return wanted;
}

void met_lists_add(uint first, HitLists hits, MetWay way) {
    for (uint i = gl_LocalInvocationID.x; i < hits.emitting; i += WORKGROUP_SIZE) {
        PathState path = path_load(first + hit_emitting[i]);
        met_add(path, met_at_surface(path, met_left(path), way));
        if (i + WORKGROUP_SIZE >= hits.emitting) break;
    }
    for (uint i = gl_LocalInvocationID.x; i < hits.escaped; i += WORKGROUP_SIZE) {
        PathState path = path_load(first + hit_escaped[i]);
        met_add(path, met_from_afar(path, met_left(path), way));
        if (i + WORKGROUP_SIZE >= hits.escaped) break;
    }
}

#endif
