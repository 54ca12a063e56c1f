// Chooses who shoots; see shoot.glsl.h.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shoot.glsl.h"
#include "../core/variants.glsl"
#include "../core/workgroup.glsl"
#include "../radiosity/power.glsl"

layout(push_constant, scalar) uniform ArgsBlock { ShootArgs args; };

void main() {
    uint i = workgroup_index() * WORKGROUP_SIZE + gl_LocalInvocationID.x;
    if (i >= args.row_count) return;
    uint side = args.row_sides.at[i].side;
    vec3 rest = args.rest.at[side].rgb;
    bool shoots = power_of(rest, args.reflectance.at[side].scalar) >= args.threshold;
    args.shot.at[side].rgb = shoots ? rest : vec3(0.0);
    args.rest.at[side].rgb = shoots ? vec3(0.0) : rest;
    if (shoots) atomicAdd(args.shooters.at[0].side, 1u);
}
