// For tests: ors together the first word of every binding but the one it writes to.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "core/tables.glsl"

layout(push_constant, scalar) uniform Args { uint count; uint factor; uint offset; } args;
layout(set = 0, binding = BIND_PATHS, scalar) buffer Out { uint at[]; } result;
layout(set = 0, binding = BIND_SHADOW_RAYS, scalar) buffer B2 { uint at[]; } b2;
layout(set = 0, binding = BIND_SEGMENTS, scalar) buffer B3 { uint at[]; } b3;
layout(set = 0, binding = BIND_RADIANCE, scalar) buffer B4 { uint at[]; } b4;
layout(set = 0, binding = BIND_FILM, scalar) buffer B5 { uint at[]; } b5;

void main() {
    if (gl_GlobalInvocationID.x != 0u) return;
    const uvec4 tables = fetch_node(0) | fetch_triangle(0) | fetch_surface(0) | fetch_instance(0) |
                         fetch_material(0) | fetch_light(0) | fetch_environment(0) |
                         floatBitsToUint(fetch_texel(0));
    result.at[0] = tables.x | tables.y | tables.z | tables.w | b2.at[0] | b3.at[0] | b4.at[0] | b5.at[0] |
                   frame.width | frame.seed;
}
