// Maps from the unit square to the domains that get sampled, each with its density.
// Disk: Shirley and Chiu 1997. Triangle: Heitz 2019, "A Low-Distortion Map Between Triangle and Square".
#ifndef AJAR_WARPS_GLSL
#define AJAR_WARPS_GLSL
#include "math.glsl"

// Unit disk, uniform: density 1 / pi by area. Concentric: neighbours in the square stay neighbours on the
// disk.
vec2 warps_disk(vec2 u) {
    const vec2 p = 2.0 * u - 1.0;
    const bool wide = abs(p.x) > abs(p.y);
    const float r = wide ? p.x : p.y;
    const float other = wide ? p.y : p.x;
    // The angle from the nearer axis, within [-pi/4, pi/4]. The centre of the square has none.
    const float phi = (0.25 * MATH_PI) * (r == 0.0 ? 0.0 : other / r);
    const vec2 along = vec2(cos(phi), sin(phi));
    return r * (wide ? along : along.yx);
}
float warps_disk_pdf_area() { return MATH_INV_PI; }

// Hemisphere around +z in proportion to the cosine (Malley's method).
vec3 warps_cosine_hemisphere(vec2 u) {
    const vec2 d = warps_disk(u);
    return vec3(d, math_safe_sqrt(1.0 - dot(d, d)));
}
float warps_cosine_hemisphere_pdf(float cos_theta) { return max(cos_theta, 0.0) * MATH_INV_PI; }

// From the axis +z: 1 - cos(theta) = h, uniform azimuth. Written in h, since 1 - cos loses all digits of
// small angles.
vec3 warps_cap(float h, float u) {
    const float phi = 2.0 * MATH_PI * u;
    const float r = math_safe_sqrt(h * (2.0 - h));
    return vec3(r * cos(phi), r * sin(phi), 1.0 - h);
}

vec3 warps_sphere(vec2 u) { return warps_cap(2.0 * u.x, u.y); }
float warps_sphere_pdf() { return 0.25 * MATH_INV_PI; }

vec3 warps_hemisphere(vec2 u) { return warps_cap(u.x, u.y); }
float warps_hemisphere_pdf() { return 0.5 * MATH_INV_PI; }

// Directions within an angle of +z, uniform. one_minus_cos: 1 - cos of that angle, in (0, 2].
vec3 warps_cone(vec2 u, float one_minus_cos) { return warps_cap(u.x * one_minus_cos, u.y); }
float warps_cone_pdf(float one_minus_cos) { return 0.5 * MATH_INV_PI / one_minus_cos; }

// Barycentric weights of a triangle's second and third vertex, uniform by area (density 1 / area).
vec2 warps_triangle(vec2 u) {
    // u.y > u.x: (u.x / 2, u.y - u.x / 2), otherwise (u.x - u.y / 2, u.y / 2).
    return 0.5 * (u + max(u - u.yx, vec2(0.0)));
}

#endif
