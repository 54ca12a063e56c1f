// Applies one function of shaders/material to many items; see material_functions.glsl.h.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "material_functions.glsl.h"
#include "core/workgroup.glsl"
#include "material/material.glsl"

layout(push_constant, scalar) uniform ArgsBlock { MaterialFunctionsArgs args; };

void write(uint word, vec4 value) { args.items_out.at[word].value = floatBitsToUint(value); }

void main() {
    const uint i = workgroup_index() * WORKGROUP_SIZE + gl_LocalInvocationID.x;
    if (i >= args.count) return;
    const vec4 uv = uintBitsToFloat(args.items_in.at[i].value);
    const uint out_word = i * MATERIAL_WORDS;
    if (OPTION == MATERIAL_TEXTURE) {
        write(out_word, texture_sample(args.index, uv.xy, uv.zw));
        return;
    }
    const MaterialPoint m = material_point(args.index, uv.xy, uv.zw, args.vertex_color);
    write(out_word, m.base_color);
    write(out_word + 1, vec4(m.emission, m.metallic));
    write(out_word + 2, vec4(m.normal_ts, m.alpha_ggx));
    write(out_word + 3, vec4(m.f0_dielectric, m.f90_dielectric));
    write(out_word + 4, vec4(material_emission(args.index, uv.xy, uv.zw),
                             material_alpha(args.index, uv.xy, uv.zw, args.vertex_color)));
}
