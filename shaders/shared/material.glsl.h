// BIND_MATERIALS: first all MaterialRecords, then all TextureRecords (FrameRecord::textures_first says
// where).
#ifndef AJAR_MATERIAL_GLSL_H
#define AJAR_MATERIAL_GLSL_H
#include "dual.glsl.h"
DUAL_BEGIN

const uint NO_TEXTURE = 0xffffffffu;

const uint MATERIAL_DOUBLE_SIDED = 1u << 0;
const uint MATERIAL_UNLIT = 1u << 1;
const uint MATERIAL_MASK = 1u << 2;  // alpha < cutoff: nothing there
const uint MATERIAL_BLEND = 1u << 3; // alpha is the probability of being there
const uint MATERIAL_EMISSIVE = 1u << 4;

// glTF 2.0 metallic-roughness; see scene.hpp's Material for the meaning of the factors.
struct MaterialRecord {
    vec4 base_color;
    vec3 emission;
    uint flags;                      // MATERIAL_*
    float metallic;
    float roughness;
    float normal_scale;
    float alpha_cutoff;
    vec3 dielectric_f0;              // min(((ior - 1) / (ior + 1))^2 * specular_color, 1) * specular
    float dielectric_f90;            // specular
    uint base_color_texture;         // index of the TextureRecord, or NO_TEXTURE
    uint metallic_roughness_texture;
    uint normal_texture;
    uint emission_texture;
};
DUAL_SIZE(MaterialRecord, 80);

const uint MATERIAL_TEXELS = 5;

// Below this GGX width (roughness 0.032) a lobe is a mirror. It spreads light over a tenth of a degree;
// narrower, the density passes 1e6 per steradian and float directions no longer resolve it.
const float DELTA_ALPHA = 1e-3f;

const uint WRAP_REPEAT = 0;
const uint WRAP_MIRROR = 1;
const uint WRAP_CLAMP = 2;
const uint TEXTURE_WRAP_V_SHIFT = 2;
const uint TEXTURE_NEAREST = 1u << 4;
const uint TEXTURE_SRGB = 1u << 5;   // texels are decoded before they are filtered
const uint TEXTURE_UV1 = 1u << 6;    // second texture coordinates

// One use of a texture by a material.
struct TextureRecord {
    uint first_texel; // in BIND_TEXELS, rows top to bottom
    uint width;
    uint height;
    uint flags;       // WRAP_* for u, WRAP_* << TEXTURE_WRAP_V_SHIFT for v, TEXTURE_*
    vec3 uv_row_u;    // u' = dot(uv_row_u, (u, v, 1))
    uint pad0;
    vec3 uv_row_v;
    uint pad1;
};
DUAL_SIZE(TextureRecord, 48);

const uint TEXTURE_TEXELS = 3;

DUAL_END
#endif
