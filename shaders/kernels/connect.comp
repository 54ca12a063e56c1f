// Which shadow rays of a segment arrive; see connect.glsl.h.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "connect.glsl.h"
#include "../core/paths.glsl"
#include "../core/segment.glsl"
#include "../geometry/bvh.glsl"
#include "../geometry/bvh_trace.glsl"

layout(push_constant, scalar) uniform ArgsBlock { ConnectArgs args; };

uint first_slot; // of the segment
uint open_rays = 0u;

BvhRay bvh_ray_of(uint i) {
    ShadowRay shadow = shadow_ray_load(first_slot + i);
    vec3 offset = leave_offset(shadow.triangle, shadow.instance, shadow.origin, shadow.direction);
    float reach = leave_reach(shadow.distance, shadow.light_triangle, shadow.light_instance, shadow.origin,
                              shadow.direction, offset);
    return BvhRay(shadow.origin + offset, shadow.direction, min(reach, BVH_FAR), shadow.triangle,
                  shadow.instance, shadow.light_triangle, shadow.light_instance, shadow.salt);
}

void bvh_found(uint i, Hit hit) {
    if (hit.triangle == NO_TRIANGLE) {
        ShadowRay shadow = shadow_ray_load(first_slot + i);
        radiance_add(shadow.home, shadow.contribution);
        ++open_rays;
    }
}

void main() {
    uint segment = segment_index(args.segments);
    if (segment == NO_SEGMENT) return;
    first_slot = segment * SEGMENT_SIZE;
    uint count = segments[segment].shadows;
    uint unfinished = bvh_trace_all(count, OPTION == 0u, true);
    if (unfinished > 0u) atomicAdd(segments[segment].loops_exhausted, unfinished);
    if (open_rays > 0u) {
        uint low = atomicAdd(segments[segment].shadows_open[0], open_rays);
        if (low + open_rays < low) atomicAdd(segments[segment].shadows_open[1], 1u);
    }
    if (gl_LocalInvocationID.x == 0u) {
        uint low = segments[segment].shadows_traced[0];
        segments[segment].shadows_traced[0] = low + count;
        segments[segment].shadows_traced[1] += low + count < low ? 1u : 0u;
    }
}
