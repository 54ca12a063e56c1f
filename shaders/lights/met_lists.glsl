// Light that the paths of a segment met, added to their radiances.
#ifndef AJAR_MET_LISTS_GLSL
#define AJAR_MET_LISTS_GLSL
#include "../core/hit_lists.glsl"
#include "met.glsl"

// `looks`: light is wanted; `all_scatter`: the surfaces are taken for white ones.
HitListsWanted met_lists_wanted(const bool looks, const bool all_scatter) {
    const bool afar = has_feature(FEATURE_ANY_ENVIRONMENT | FEATURE_SOFT_LIGHTS);
    return HitListsWanted(all_scatter, has_feature(FEATURE_SOFT_LIGHTS), looks, looks && afar);
}

void met_lists_add(uint first, HitLists hits, bool camera, bool every) {
    for (uint i = gl_LocalInvocationID.x; i < hits.emitting; i += WORKGROUP_SIZE) {
        PathState path = path_load(first + hit_emitting_slot(i));
        met_add(path, met_at_surface(path, met_left(path), camera, every));
        if (i + WORKGROUP_SIZE >= hits.emitting) break;
    }
    for (uint i = gl_LocalInvocationID.x; i < hits.escaped; i += WORKGROUP_SIZE) {
        PathState path = path_load(first + hit_escaped_slot(i));
        met_add(path, met_from_afar(path, met_left(path), camera, every));
        if (i + WORKGROUP_SIZE >= hits.escaped) break;
    }
}

#endif
