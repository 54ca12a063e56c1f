// Which shadow rays of a segment arrive; see connect.glsl.h.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "connect.glsl.h"
#include "../core/paths.glsl"
#include "../core/segment.glsl"
#include "../geometry/bvh.glsl"

layout(push_constant, scalar) uniform ArgsBlock { ConnectArgs args; };

void main() {
    uint segment = segment_index(args.segments);
    if (segment == NO_SEGMENT) return;
    uint first = segment * SEGMENT_SIZE;
    uint count = segments[segment].shadows;
    uint exhausted = 0u;
    uint open = 0u;
    for (uint i = gl_LocalInvocationID.x; i < count; i += WORKGROUP_SIZE) {
        ShadowRay shadow = shadow_ray_load(first + i);
        vec3 offset = leave_offset(shadow.triangle, shadow.instance, shadow.origin, shadow.direction);
        float reach = leave_reach(shadow.distance, shadow.light_triangle, shadow.light_instance,
            shadow.origin,
                                  shadow.direction, offset);
        BvhRay ray = BvhRay(shadow.origin + offset, shadow.direction, min(reach, BVH_FAR), shadow.triangle,
                            shadow.instance, shadow.light_triangle, shadow.light_instance, shadow.salt);
        Hit hit = bvh_trace(ray, true);
        exhausted += hit.exhausted ? 1u : 0u;
        if (hit.triangle == NO_TRIANGLE) {
            radiance_add(shadow.home, shadow.contribution);
            ++open;
        }
    }
    if (exhausted > 0u) atomicAdd(segments[segment].loops_exhausted, exhausted);
    if (open > 0u) {
        uint low = atomicAdd(segments[segment].shadows_open[0], open);
        if (low + open < low) atomicAdd(segments[segment].shadows_open[1], 1u);
    }
    if (gl_LocalInvocationID.x == 0u) {
        uint low = segments[segment].shadows_traced[0];
        segments[segment].shadows_traced[0] = low + count;
        segments[segment].shadows_traced[1] += low + count < low ? 1u : 0u;
    }
}
