// The material at a point: factors times textures (glTF 2.0, 3.9), before any lobe is made of it.
// All textures are fetched here, once: on lavapipe both sides of a branch run, so fetches inside lobes cost
// every lane.
#ifndef AJAR_MATERIAL_GLSL
#define AJAR_MATERIAL_GLSL
#include "../core/math.glsl"
#include "texture.glsl"

struct MaterialPoint {
    vec4 base_color;     // linear; a: probability that the surface is there (material_alpha)
    vec3 emission;       // radiance, W/(m^2 sr)
    float metallic;
    float alpha_ggx;     // GGX width: roughness squared
    vec3 normal_ts;      // unit; tangent space: x tangent, y bitangent, z normal
    vec3 f0_dielectric;  // reflectance at normal incidence
    float f90_dielectric;
    uint flags;          // MATERIAL_*
};

vec4 material_texture(uint feature, uint texture_index, vec2 uv0, vec2 uv1) {
    if (!has_feature(feature)) return vec4(1.0);
    return texture_sample(texture_index, uv0, uv1);
}

// Probability that the surface is there, of its final alpha: opaque 1; mask 0 or 1; blend alpha.
float material_coverage(uint flags, float cutoff, float alpha) {
    const float masked = alpha < cutoff ? 0.0 : 1.0;
    const float blended = (flags & MATERIAL_BLEND) != 0u ? clamp(alpha, 0.0, 1.0) : 1.0;
    return (flags & MATERIAL_MASK) != 0u ? masked : blended;
}

// For alpha tests during traversal: nothing but alpha is fetched and filtered. Deals with all alpha modes.
float material_alpha(uint material, vec2 uv0, vec2 uv1, vec4 vertex_color) {
    const uint record = material * MATERIAL_TEXELS;
    const uint flags = fetch_material(record + 1).w;
    const float cutoff = uintBitsToFloat(fetch_material(record + 2).w);
    const uint texture_index = fetch_material(record + 4).x;
    const float factor = uintBitsToFloat(fetch_material(record).w) * vertex_color.a;
    const float alpha = factor * material_texture(FEATURE_TEXTURES, texture_index, uv0, uv1).a;
    return material_coverage(flags, cutoff, alpha);
}

// Radiance that leaves the surface at this point, W/(m^2 sr); which side emits is the caller's business.
vec3 material_emission(uint material, vec2 uv0, vec2 uv1) {
    const uint record = material * MATERIAL_TEXELS;
    const uint texture_index = fetch_material(record + 4).w;
    const vec3 factor = uintBitsToFloat(fetch_material(record + 1).xyz);
    return factor * material_texture(FEATURE_EMISSION_TEXTURES, texture_index, uv0, uv1).rgb;
}

vec3 material_normal(uint texture_index, float scale, vec2 uv0, vec2 uv1) {
    if (!has_feature(FEATURE_NORMAL_MAPS) || texture_index == NO_TEXTURE) return vec3(0.0, 0.0, 1.0);
    const vec3 texel = texture_sample_linear(texture_index, uv0, uv1).xyz;
    const vec3 n = (2.0 * texel - 1.0) * vec3(scale, scale, 1.0);
    const float length2 = dot(n, n);
    // Texels of opposite normals can cancel when they are filtered.
    return length2 > 0.0 ? n * inversesqrt(length2) : vec3(0.0, 0.0, 1.0);
}

MaterialPoint material_point(uint material, vec2 uv0, vec2 uv1, vec4 vertex_color) {
    const uint record = material * MATERIAL_TEXELS;
    const uvec4 emission_flags = fetch_material(record + 1);
    // Metallic, roughness, normal scale, alpha cutoff.
    const vec4 factors = uintBitsToFloat(fetch_material(record + 2));
    const vec4 dielectric = uintBitsToFloat(fetch_material(record + 3));
    const uvec4 textures = fetch_material(record + 4);
    const vec4 factor = uintBitsToFloat(fetch_material(record)) * vertex_color;

    MaterialPoint m;
    m.flags = emission_flags.w;
    m.base_color = clamp(factor * material_texture(FEATURE_TEXTURES, textures.x, uv0, uv1), 0.0, 1.0);
    m.base_color.a = material_coverage(m.flags, factors.w, m.base_color.a);
    m.emission = uintBitsToFloat(emission_flags.xyz) *
                 material_texture(FEATURE_EMISSION_TEXTURES, textures.w, uv0, uv1).rgb;
    m.normal_ts = material_normal(textures.z, factors.z, uv0, uv1);
    m.metallic = 0.0;
    m.alpha_ggx = 1.0;
    m.f0_dielectric = vec3(0.0);
    m.f90_dielectric = 0.0;
    if (has_feature(FEATURE_SPECULAR)) {
        vec4 mr = vec4(1.0);
        if (has_feature(FEATURE_TEXTURES)) mr = texture_sample_linear(textures.y, uv0, uv1);
        m.metallic = clamp(factors.x * mr.b, 0.0, 1.0);
        m.alpha_ggx = math_sqr(clamp(factors.y * mr.g, 0.0, 1.0));
        m.f0_dielectric = dielectric.xyz;
        m.f90_dielectric = dielectric.w;
    }
    return m;
}

#endif
