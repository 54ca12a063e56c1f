// The specular lobe without its Fresnel factor: GGX (Walter et al. 2007) with height-correlated Smith masking
// and shadowing (Heitz 2014, "Understanding the Masking-Shadowing Function"; Lagarde and de Rousiers 2014,
// eq. 26), sampled by the visible normals that reflect above the surface (Eto and Tokuyoshi 2023, "Bounded
// VNDF Sampling for Smith-GGX Reflections", which narrows the spherical caps of Dupuy and Benyoub 2023).
// Isotropic, alpha = roughness^2 > 0.
#ifndef AJAR_MICROFACET_GLSL
#define AJAR_MICROFACET_GLSL
#include "../core/math.glsl"

// f / F in 1/sr, and the density of microfacet_sample by solid angle.
struct MicrofacetValue {
    float f;
    float pdf;
    float wo_dot_h; // cosine that Fresnel's formula takes
};

// The share of the cap below its equator that can reflect above the surface at all (equation 5 of Eto and
// Tokuyoshi).
float microfacet_bound(float alpha, vec3 wo) {
    const float a2 = alpha * alpha;
    const float s2 = math_sqr(1.0 + sqrt(wo.x * wo.x + wo.y * wo.y));
    return (1.0 - a2) * s2 / (s2 + a2 * wo.z * wo.z);
}

// For wo.z > 0 and wi.z > 0.
MicrofacetValue microfacet_eval(float alpha, vec3 wo, vec3 wi) {
    const float a2 = alpha * alpha;
    const vec3 h = wo + wi;
    const float h_length2 = max(dot(h, h), 1e-30);
    const float hxy2 = h.x * h.x + h.y * h.y;
    // D = 1 / (pi alpha^2 (tan^2 / alpha^2 + 1)^2 cos^4), written without 1 - cos^2, which has no digits left
    // in a mirror.
    // e lies in [alpha^2, 1]; below, the squares of h have underflowed: wo and wi graze from opposite sides.
    const float e = max((hxy2 + a2 * h.z * h.z) / h_length2, a2);
    const float d = a2 * MATH_INV_PI / (e * e);
    const float wo_slope = sqrt(a2 + (1.0 - a2) * wo.z * wo.z);
    const float wi_slope = sqrt(a2 + (1.0 - a2) * wi.z * wi.z);
    // G2 / (4 cos cos).
    const float visibility = 0.5 / max(wi.z * wo_slope + wo.z * wi_slope, 1e-30);
    MicrofacetValue value;
    value.f = d * visibility;
    // Jacobian of reflection and projected area of the visible normals: D / (2 (bound cos + slope)).
    value.pdf = 0.5 * d / (microfacet_bound(alpha, wo) * wo.z + wo_slope);
    value.wo_dot_h = dot(wo, h) * inversesqrt(h_length2);
    return value;
}

// The microfacet normal; mirror wo about it. May still send a little light below the surface: absorbed.
vec3 microfacet_sample_normal(float alpha, vec3 wo, vec2 u) {
    // The stretched view sees a unit hemisphere of normals: a spherical cap around it, halved.
    const vec3 view = normalize(vec3(alpha * wo.xy, wo.z));
    const float lower = microfacet_bound(alpha, wo) * view.z;
    const float z = (1.0 - u.y) * (1.0 + lower) - lower;
    const float r = math_safe_sqrt(1.0 - z * z);
    const float phi = 2.0 * MATH_PI * u.x;
    const vec3 h = vec3(r * cos(phi), r * sin(phi), z) + view;
    // h.z is positive but for rounding.
    return normalize(vec3(alpha * h.xy, max(h.z, 1e-12)));
}

#endif
