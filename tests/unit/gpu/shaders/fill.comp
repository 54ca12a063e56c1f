// For tests: out[i] = i * factor + offset + OPTION for i < count, one thread each.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "core/variants.glsl"
#include "core/workgroup.glsl"
#include "shared/bindings.glsl.h"

layout(push_constant, scalar) uniform Args { uint count; uint factor; uint offset; } args;
layout(set = 0, binding = BIND_PATHS, scalar) buffer Out { uint at[]; } result;

void main() {
    const uint i = workgroup_index() * WORKGROUP_SIZE + gl_LocalInvocationID.x;
    if (i >= args.count) return;
    result.at[i] = i * args.factor + args.offset + OPTION;
}
