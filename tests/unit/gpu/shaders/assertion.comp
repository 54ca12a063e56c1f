// For tests: every fifth thread fails an ASSERT, whether or not the build has AJAR_DEBUG.
#version 460
#extension GL_GOOGLE_include_directive : require
#define AJAR_DEBUG 1
#include "core/assert.glsl"

layout(push_constant, scalar) uniform Args { uint count; uint factor; uint offset; } args;

void main() {
    const uint i = workgroup_index() * WORKGROUP_SIZE + gl_LocalInvocationID.x;
    ASSERT(i >= args.count || i % 5u != 0u)
}
