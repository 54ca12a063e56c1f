// Which shadow rays of a segment arrive; see connect.glsl.h.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "connect.glsl.h"
#include "../core/paths.glsl"
#include "../core/segment.glsl"
#include "../geometry/bvh.glsl"
#include "../geometry/bvh_trace.glsl"

layout(push_constant, scalar) uniform ArgsBlock { ConnectArgs args; };

uint first_slot; // of this workgroup's share of the segment
uint open_rays = 0u;

BvhRay bvh_ray_of(uint i) {
    ShadowRay shadow = shadow_ray_load(first_slot + i);
    uint salt = has_feature(FEATURE_ALPHA) ? segment_salt(args.segments, shadow.home, true) : 0u;
    return BvhRay(shadow.origin, shadow.direction, min(shadow.reach, BVH_FAR), shadow.leaves, shadow.instance,
                  salt);
}

void bvh_found(uint i, Hit hit, bool done) {
    ShadowRay shadow = shadow_ray_load(first_slot + i);
    bool open = done && hit.triangle == NO_TRIANGLE;
    if (OPTION == CONNECT_LEARN) {
        uint counter = shadow_ray_counter_load(first_slot + i);
        if (done) atomicAdd(frame.visibility_counts.at[counter].traced, 1u);
        if (open) atomicAdd(frame.visibility_counts.at[counter].arrived, 1u);
        return;
    }
    radiance_add(shadow.home, open ? shadow.contribution : vec3(0.0));
    open_rays += open ? 1u : 0u;
}

void main() {
    SegmentShare share = segment_share(args.segments);
    uint segment = share.segment;
    if (segment == NO_SEGMENT) return;
    first_slot = segment * SEGMENT_SIZE + share.first;
    uint count = segments[segment].shadows;
    uint unfinished = bvh_trace_all(segment_share_of(share, count), OPTION == CONNECT_TOGETHER, true);
    if (unfinished > 0u) atomicAdd(segments[segment].loops_exhausted, unfinished);
    if (open_rays > 0u) {
        uint low = atomicAdd(segments[segment].shadows_open[0], open_rays);
        if (low + open_rays < low) atomicAdd(segments[segment].shadows_open[1], 1u);
    }
    if (gl_LocalInvocationID.x == 0u && share.first == 0u) {
        uint low = segments[segment].shadows_traced[0];
        segments[segment].shadows_traced[0] = low + count;
        segments[segment].shadows_traced[1] += low + count < low ? 1u : 0u;
    }
}
