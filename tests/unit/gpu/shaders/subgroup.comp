// For tests: out[i] = 1 + the sum of i over its workgroup by shuffles, or 0 in the plain variant.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_KHR_shader_subgroup_shuffle : enable
#include "core/variants.glsl"
#include "shared/bindings.glsl.h"

layout(push_constant, scalar) uniform Args { uint count; uint factor; uint offset; } args;
layout(set = 0, binding = BIND_PATHS, scalar) buffer Out { uint at[]; } result;

void main() {
    const uint i = gl_GlobalInvocationID.x;
    uint sum = 0;
#ifdef AJAR_SUBGROUP
    for (uint lane = 0; lane < WORKGROUP_SIZE; ++lane) sum += subgroupShuffle(i, lane);
    sum += 1;
#endif
    if (i < args.count) result.at[i] = sum;
}
