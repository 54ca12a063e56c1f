// For tests: out[i] = word i of each of the eight tables, through core/tables.glsl.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "core/tables.glsl"
#include "core/workgroup.glsl"

layout(push_constant, scalar) uniform Args { uint count; uint factor; uint offset; } args;
struct Row { uvec4 word[8]; };
layout(set = 0, binding = BIND_PATHS, scalar) buffer Out { Row at[]; } result;

void main() {
    const uint i = workgroup_index() * WORKGROUP_SIZE + gl_LocalInvocationID.x;
    if (i >= args.count) return;
    result.at[i].word[0] = fetch_node(i);
    result.at[i].word[1] = fetch_triangle(i);
    result.at[i].word[2] = fetch_surface(i);
    result.at[i].word[3] = fetch_instance(i);
    result.at[i].word[4] = fetch_material(i);
    result.at[i].word[5] = floatBitsToUint(fetch_texel(i));
    result.at[i].word[6] = fetch_light(i);
    result.at[i].word[7] = fetch_environment(i);
}
