// Unit vectors in 32 bits: the octahedron's map, 2 x snorm16 (Cigolle et al. 2014, "A Survey of Efficient
// Representations for Independent Unit Vectors"). host/render/octahedral.hpp encodes alike:
// p = n / (|n.x| + |n.y| + |n.z|); where n.z < 0: p.xy = (1 - |p.yx|) * (p.xy < 0 ? -1 : 1);
// each rounded to round(p * 32767), x in the low half word, y in the high one. Angular error below
// 6.5e-5 radians.
#ifndef AJAR_OCTAHEDRAL_GLSL
#define AJAR_OCTAHEDRAL_GLSL
#extension GL_GOOGLE_include_directive : require

vec3 octahedral_decode(uint packed) {
    // Sign extension and a product: half the instructions of unpackSnorm2x16, which must clamp -32768. The
    // scale cancels in normalize.
    const vec2 p = vec2(int(packed << 16) >> 16, int(packed) >> 16);
    const float z = 32767.0 - abs(p.x) - abs(p.y);
    const float fold = max(-z, 0.0);
    return normalize(vec3(p.x - (p.x < 0.0 ? -fold : fold), p.y - (p.y < 0.0 ? -fold : fold), z));
}

uint octahedral_encode(vec3 n) {
    const vec2 p = n.xy / (abs(n.x) + abs(n.y) + abs(n.z));
    const vec2 side = vec2(p.x < 0.0 ? -1.0 : 1.0, p.y < 0.0 ? -1.0 : 1.0);
    const vec2 folded = n.z < 0.0 ? (1.0 - abs(p.yx)) * side : p;
    const ivec2 rounded = ivec2(floor(folded * 32767.0 + 0.5));
    return (uint(rounded.x) & 0xffffu) | uint(rounded.y) << 16;
}

#endif
