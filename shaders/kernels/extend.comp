// Where each ray of a segment meets the scene; see extend.glsl.h.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "extend.glsl.h"
#include "../core/paths.glsl"
#include "../core/segment.glsl"
#include "../geometry/bvh.glsl"

layout(push_constant, scalar) uniform ArgsBlock { ExtendArgs args; };

void main() {
    uint segment = segment_index(args.segments);
    if (segment == NO_SEGMENT) return;
    uint first = segment * SEGMENT_SIZE;
    uint count = segments[segment].paths;
    uint exhausted = 0u;
    for (uint i = gl_LocalInvocationID.x; i < count; i += WORKGROUP_SIZE) {
        PathState path = path_load(first + i);
        vec3 offset = leave_offset(path.triangle, path.instance, path.origin, path.direction);
        BvhRay ray = BvhRay(path.origin + offset, path.direction, BVH_FAR, path.triangle, path.instance,
            NO_TRIANGLE, 0u,
                            path.salt);
        Hit hit = bvh_trace(ray, false);
        path_store_hit(first + i, hit.triangle, hit.instance, hit.u, hit.v);
        exhausted += hit.exhausted ? 1u : 0u;
    }
    if (exhausted > 0u) atomicAdd(segments[segment].loops_exhausted, exhausted);
    if (gl_LocalInvocationID.x == 0u) {
        uint low = segments[segment].rays_traced[0];
        segments[segment].rays_traced[0] = low + count;
        segments[segment].rays_traced[1] += low + count < low ? 1u : 0u;
    }
}
