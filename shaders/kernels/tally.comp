// What the rays of form factors met; see tally.glsl.h.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "tally.glsl.h"
#include "../core/paths.glsl"
#include "../core/segment.glsl"
#include "../geometry/triangle.glsl"
#include "../radiosity/patch_lookup.glsl"

layout(push_constant, scalar) uniform ArgsBlock { TallyArgs args; };

uint side_met(PathState path) {
    // Lanes that met nothing look the first triangle up all the same.
    uint triangle = path.triangle == NO_TRIANGLE ? 0u : path.triangle;
    vec3 p0;
    vec3 p1;
    vec3 p2;
    triangle_vertices(triangle, p0, p1, p2);
    bool back_face = dot(cross(p1 - p0, p2 - p0), path.direction) > 0.0;
    PatchHit hit = patch_lookup(triangle, path.u, path.v);
    bool counts = path.pdf > 0.0 && hit.index != PATCH_NONE;
    uint side = counts ? patch_side(hit.index, back_face) : args.side_count + SIDE_NOWHERE;
    bool sky = path.pdf > 0.0 && path.triangle == NO_TRIANGLE;
    return sky ? args.side_count + SIDE_SKY : side;
}

void add(uint which, uint count) {
    if (count == 0u) return;
    if (which == SIDE_SKY) {
        uint low = atomicAdd(args.totals.at[0].rays_sky[0], count);
        if (low + count < low) atomicAdd(args.totals.at[0].rays_sky[1], 1u);
    } else {
        uint low = atomicAdd(args.totals.at[0].rays_nowhere[0], count);
        if (low + count < low) atomicAdd(args.totals.at[0].rays_nowhere[1], 1u);
    }
}

void main() {
    uint segment = segment_index(args.segments);
    if (segment == NO_SEGMENT) return;
    uint first = segment * SEGMENT_SIZE;
    uint count = segments[segment].paths;
    uint sky = 0u;
    uint nowhere = 0u;
    for (uint i = gl_LocalInvocationID.x; i < count; i += WORKGROUP_SIZE) {
        PathState path = path_load(first + i);
        PathOwner owner = segment_owner(args.segments, first + i);
        uint side = side_met(path);
        uint row = (owner.ordinal - args.first_row) << args.rays_log2;
        args.entries.at[row + owner.sample_index].side = side;
        if (args.met.at[side].side == 0u) atomicOr(args.met.at[side].side, 1u);
        sky += side == args.side_count + SIDE_SKY ? 1u : 0u;
        nowhere += side == args.side_count + SIDE_NOWHERE ? 1u : 0u;
    }
    add(SIDE_SKY, sky);
    add(SIDE_NOWHERE, nowhere);
}
