// Where each ray of a segment meets the scene; see extend.glsl.h.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "extend.glsl.h"
#include "../core/paths.glsl"
#include "../core/segment.glsl"
#include "../geometry/bvh.glsl"
#include "../geometry/bvh_trace.glsl"

layout(push_constant, scalar) uniform ArgsBlock { ExtendArgs args; };

uint first_slot; // of this workgroup's share of the segment

BvhRay bvh_ray_of(uint i) {
    PathState path = path_load(first_slot + i);
    uint salt = has_feature(FEATURE_ALPHA) ? segment_salt(args.segments, path.home, false) : 0u;
    return BvhRay(path.origin, path.direction, BVH_FAR, path.leaves, path.instance, salt);
}

void bvh_found(uint i, Hit hit, bool done) {
    path_store_hit(first_slot + i, hit.triangle, hit.instance, hit.u, hit.v);
}

void main() {
    SegmentShare share = segment_share(args.segments);
    uint segment = share.segment;
    if (segment == NO_SEGMENT) return;
    first_slot = segment * SEGMENT_SIZE + share.first;
    uint count = segments[segment].paths;
    uint unfinished = bvh_trace_all(segment_share_of(share, count), OPTION == EXTEND_CAMERA, false);
    if (unfinished > 0u) atomicAdd(segments[segment].loops_exhausted, unfinished);
    if (gl_LocalInvocationID.x == 0u && share.first == 0u) {
        uint low = segments[segment].rays_traced[0];
        segments[segment].rays_traced[0] = low + count;
        segments[segment].rays_traced[1] += low + count < low ? 1u : 0u;
    }
}
