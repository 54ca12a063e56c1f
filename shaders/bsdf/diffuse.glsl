// The diffuse lobe: Lambert's constant albedo / pi over the hemisphere of the normal.
#ifndef AJAR_DIFFUSE_GLSL
#define AJAR_DIFFUSE_GLSL
#include "../core/warps.glsl"

vec3 diffuse_eval(vec3 albedo) { return albedo * MATH_INV_PI; }
float diffuse_pdf(vec3 wi) { return warps_cosine_hemisphere_pdf(wi.z); }
vec3 diffuse_sample(vec2 u) { return warps_cosine_hemisphere(u); }

#endif
