// Textures: 8-bit RGBA in one texel buffer, wrapped, decoded and filtered here, so that every device gives
// the same values. Texel (i, j) has its centre at ((i + 0.5) / width, (j + 0.5) / height); row 0 is at v = 0,
// the top (glTF 2.0, 3.8.4).
#ifndef AJAR_TEXTURE_GLSL
#define AJAR_TEXTURE_GLSL
#include "../core/color.glsl"
#include "../core/tables.glsl"
#include "../shared/material.glsl.h"

// One axis: the two texels and the weight of the second.
struct TextureAxis {
    int i0;
    int i1;
    float t;
};

TextureAxis texture_axis(float u, uint size, uint wrap, bool nearest) {
    // Beyond 2^20 repeats a coordinate has fewer than 4 bits left within a repeat; NaN and Inf have none: 0,
    // any place.
    u = abs(u) <= 1048576.0 ? u : 0.0;
    // Mirror: the saw of period 2 folded at 1; repeat: the saw of period 1; both in [0, 1].
    const float period = wrap == WRAP_MIRROR ? 2.0 : 1.0;
    const float saw = u - period * floor(u / period);
    u = wrap == WRAP_CLAMP ? clamp(u, 0.0, 1.0) : (saw > 1.0 ? 2.0 - saw : saw);
    const float x = u * float(int(size)) - (nearest ? 0.0 : 0.5);
    const float base = floor(x);
    const int last = int(size) - 1;
    const int i0 = int(base);
    // Outside by one at most. Beyond a mirror is the edge texel again, as with clamping.
    const int below = wrap == WRAP_REPEAT ? last : 0;
    const int above = wrap == WRAP_REPEAT ? 0 : last;
    TextureAxis axis;
    axis.i0 = i0 < 0 ? below : (i0 > last ? above : i0);
    axis.i1 = i0 >= last ? above : i0 + 1;
    axis.t = nearest ? 0.0 : x - base;
    return axis;
}

vec4 texture_texel(uint index, bool srgb) {
    const vec4 texel = fetch_texel(index);
    return vec4(srgb ? color_srgb_decode(texel.rgb) : texel.rgb, texel.a);
}

vec4 texture_filter(uint texture_index, vec2 uv0, vec2 uv1, bool may_be_srgb) {
    if (texture_index == NO_TEXTURE) return vec4(1.0);
    const uint record = frame.textures_first + texture_index * TEXTURE_TEXELS;
    const uvec4 head = fetch_material(record);
    const vec3 row_u = uintBitsToFloat(fetch_material(record + 1).xyz);
    const vec3 row_v = uintBitsToFloat(fetch_material(record + 2).xyz);
    const uint flags = head.w;
    const vec2 raw = (flags & TEXTURE_UV1) != 0u ? uv1 : uv0;
    const bool nearest = (flags & TEXTURE_NEAREST) != 0u;
    const vec2 uv = vec2(dot(row_u, vec3(raw, 1.0)), dot(row_v, vec3(raw, 1.0)));
    const TextureAxis u = texture_axis(uv.x, head.y, flags & 3u, nearest);
    const TextureAxis v = texture_axis(uv.y, head.z, (flags >> TEXTURE_WRAP_V_SHIFT) & 3u, nearest);
    const uint row0 = head.x + uint(v.i0) * head.y;
    const uint row1 = head.x + uint(v.i1) * head.y;
    // All four even for nearest, whose weights are 0: lanes of a subgroup differ in their filter.
    const bool srgb = may_be_srgb && (flags & TEXTURE_SRGB) != 0u;
    const vec4 t00 = texture_texel(row0 + uint(u.i0), srgb);
    const vec4 t10 = texture_texel(row0 + uint(u.i1), srgb);
    const vec4 t01 = texture_texel(row1 + uint(u.i0), srgb);
    const vec4 t11 = texture_texel(row1 + uint(u.i1), srgb);
    return mix(mix(t00, t10, u.t), mix(t01, t11, u.t), v.t);
}

// Alpha is linear whatever the texture's flags. NO_TEXTURE: 1.
vec4 texture_sample(uint texture_index, vec2 uv0, vec2 uv1) {
    return texture_filter(texture_index, uv0, uv1, true);
}

// For uses that are never sRGB (metallic-roughness, normals): the same without
// code for decoding, a quarter faster.
vec4 texture_sample_linear(uint texture_index, vec2 uv0, vec2 uv1) {
    return texture_filter(texture_index, uv0, uv1, false);
}

#endif
