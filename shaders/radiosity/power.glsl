// What a side sends out.
#ifndef AJAR_RADIOSITY_POWER_GLSL
#define AJAR_RADIOSITY_POWER_GLSL
#include "../core/color.glsl"
#include "../core/math.glsl"

// W of luminance, of constant radiance over an area (m^2) of Lambertian surface.
float power_of(vec3 radiance, float area) { return MATH_PI * area * color_luminance(abs(radiance)); }

#endif
