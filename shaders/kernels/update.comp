// Takes a product of rows over into the solution; see update.glsl.h.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "update.glsl.h"
#include "../core/variants.glsl"
#include "../core/workgroup.glsl"

layout(push_constant, scalar) uniform ArgsBlock { UpdateArgs args; };

void main() {
    uint i = workgroup_index() * WORKGROUP_SIZE + gl_LocalInvocationID.x;
    if (i >= args.row_count) return;
    uint side = args.row_sides.at[args.first_row + i].side;
    vec3 reflected = args.reflectance.at[side].rgb * args.received.at[side].rgb;
    vec3 before = args.solution.at[side].rgb;
    vec3 rest = reflected + args.rest.at[side].rgb;
    vec3 after = before + reflected;
    if (OPTION == UPDATE_GATHER) {
        after = args.source.at[side].rgb + reflected;
        rest = after - before;
    }
    args.solution.at[side].rgb = after;
    args.rest.at[side].rgb = rest;
}
