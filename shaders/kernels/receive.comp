// Rows of form factors times a vector; see receive.glsl.h.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "receive.glsl.h"
#include "../core/variants.glsl"
#include "../core/workgroup.glsl"

layout(push_constant, scalar) uniform ArgsBlock { ReceiveArgs args; };

layout(set = 0, binding = BIND_SIDE_VALUES) uniform usamplerBuffer side_texels;

const uint MAX_WORDS = 32768u; // below lavapipe's limit of iterations

vec4 value_of(uint side) {
    if (TEXEL_BUFFERS != 0u) return uintBitsToFloat(texelFetch(side_texels, int(side)));
    SideValue value = args.from.at[side];
    return vec4(value.rgb, value.scalar);
}

void main() {
    uint i = workgroup_index() * WORKGROUP_SIZE + gl_LocalInvocationID.x;
    if (i >= args.row_count) return;
    uint words = 1u << (args.rays_log2 - 2u);
    vec4 sum = vec4(0.0);
    for (uint w = 0u; w < min(words, MAX_WORDS); ++w) {
        RowWord word = args.rows.at[i * words + w];
        vec4 first = value_of(word.sides[0]) + value_of(word.sides[1]);
        vec4 second = value_of(word.sides[2]) + value_of(word.sides[3]);
        sum += first + second;
    }
    sum *= 1.0 / float(int(words * ROW_ENTRIES_PER_WORD));
    args.to.at[args.row_sides.at[args.first_row + i].side] = SideValue(sum.rgb, sum.a);
}
