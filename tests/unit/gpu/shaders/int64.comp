// For tests: uses 64-bit integers, which Ajar neither requires nor enables. The validation layer must object.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_shader_explicit_arithmetic_types_int64 : require
#include "core/variants.glsl"
#include "shared/bindings.glsl.h"

layout(push_constant, scalar) uniform Args { uint count; uint factor; uint offset; } args;
layout(set = 0, binding = BIND_PATHS, scalar) buffer Out { uint at[]; } result;

void main() {
    const uint64_t product = uint64_t(args.factor) * uint64_t(args.offset);
    if (gl_GlobalInvocationID.x < args.count) result.at[gl_GlobalInvocationID.x] = uint(product >> 32);
}
