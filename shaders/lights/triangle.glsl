// Emissive triangle. FEATURE_WIDE_TRIANGLES: sampled uniformly by the solid angle that it covers (Arvo
// 1995, "Stratified Sampling of Spherical Triangles"), the density is 1 / solid angle wherever it is hit.
// The solid angle is Van Oosterom and Strackee's (1983); the sample solves their formula for the corner of
// a sub-triangle, as Peters 2021 does for polygons ("BRDF Importance Sampling for Polygonal Lights"), which
// needs no arc cosine. Otherwise: uniformly by area, carried over to solid angle, pdf = d^2 / (A |cos|).
#ifndef AJAR_LIGHTS_TRIANGLE_GLSL
#define AJAR_LIGHTS_TRIANGLE_GLSL
#include "../core/math.glsl"
#include "../core/warps.glsl"
#include "../geometry/leave.glsl"
#include "../geometry/surface.glsl"
#include "../material/material.glsl"
#include "light_sample.glsl"

// A triangle as seen from a point: corners a, b, c at distances l, in units of the scene's radius, so that
// no cube of a distance leaves the range of floats. `ab` and so on are products of vectors.
struct SphericalTriangle {
    vec3 lengths;
    float ab;
    float bc;
    float ca;
    // Van Oosterom and Strackee: tan(solid angle / 2) = volume / (base + rest).
    float volume;     // |dot(a, cross(b, c))|
    float base;       // la lb lc + ab lc
    float rest;       // bc la + ca lb
    float half_angle; // half the solid angle, [0, pi]
};

SphericalTriangle light_triangle_seen(vec3 point, vec3 p0, vec3 p1, vec3 p2) {
    const float scale = 1.0 / frame.scene_radius;
    const vec3 a = (p0 - point) * scale;
    const vec3 b = (p1 - point) * scale;
    const vec3 c = (p2 - point) * scale;
    SphericalTriangle t;
    t.lengths = sqrt(vec3(dot(a, a), dot(b, b), dot(c, c)));
    t.ab = dot(a, b);
    t.bc = dot(b, c);
    t.ca = dot(c, a);
    // By the edges, as dot(a, cross(b, c)) cancels for small triangles.
    t.volume = abs(dot(a, cross(p1 - p0, p2 - p0))) * (scale * scale);
    t.base = t.lengths.x * t.lengths.y * t.lengths.z + t.ab * t.lengths.z;
    t.rest = t.bc * t.lengths.x + t.ca * t.lengths.y;
    t.half_angle = math_angle(t.volume, t.base + t.rest);
    return t;
}

// Density by solid angle (1/sr); 0 where there is nothing to sample: no area, or seen from its own plane.
float light_triangle_density(SphericalTriangle t) {
    const float pdf = 0.5 / t.half_angle;
    return t.half_angle > 0.0 && pdf <= LIGHT_FAR ? pdf : 0.0;
}

// Density by solid angle (1/sr) with which light_triangle_sample finds the unit vector `direction` from
// `point` to emissive triangle `triangle` (leaf order, its frame the world's), which the ray meets. 0 for
// rays in its plane: those are never sampled.
float light_pdf_triangle(vec3 point, vec3 direction, uint triangle) {
    vec3 p0;
    vec3 p1;
    vec3 p2;
    triangle_vertices(triangle, p0, p1, p2);
    if (has_feature(FEATURE_WIDE_TRIANGLES))
        return light_triangle_density(light_triangle_seen(point, p0, p1, p2));
    const vec3 normal = cross(p1 - p0, p2 - p0); // twice the area long
    const float facing = abs(dot(direction, normal));
    const float distance = abs(dot(p0 - point, normal)) / facing;
    const float pdf = 2.0 * distance * distance / facing;
    return facing > 0.0 && pdf <= LIGHT_FAR ? pdf : 0.0;
}

// Barycentric weights of the second and third corner, uniform by solid angle S. First a corner d on the arc
// from a to c, such that the triangle a, b, d has the share u.x of S. It is a mirrored at h = x a + y c
// (all of them unit vectors), so that d |h|^2 = (x^2 - y^2) a + 2 y (x + y dot(a, c)) c; Van Oosterom and
// Strackee's formula for a, b, d then asks for y : x = base sin(u.x S / 2) : volume cos(u.x S / 2) - rest
// sin(u.x S / 2). Then a point on the arc from b to d, uniform in the cosine of its angle from b, which is
// how wide the triangle is there.
vec2 light_triangle_barycentric(SphericalTriangle t, vec2 u) {
    const vec3 opposite = t.lengths.yzx * t.lengths.zxy; // lb lc and so on
    const float inverse = 1.0 / (t.lengths.x * opposite.x);
    const float cosine_ab = t.ab * t.lengths.z * inverse;
    const float cosine_bc = t.bc * t.lengths.x * inverse;
    const float cosine_ca = t.ca * t.lengths.y * inverse;

    const float angle = u.x * t.half_angle;
    const vec2 turn = math_sine_cosine(angle);
    const float x = t.volume * turn.y - t.rest * turn.x;
    const float y = t.base * turn.x;
    const float size2 = 1.0 / (x * x + y * y + 2.0 * x * y * cosine_ca);
    const float d_of_a = (x - y) * (x + y) * size2;
    const float d_of_c = 2.0 * y * (x + y * cosine_ca) * size2;

    const float cosine_bd = d_of_a * cosine_ab + d_of_c * cosine_bc;
    const float cosine = 1.0 - u.y * (1.0 - cosine_bd);
    const float of_d = math_safe_sqrt(u.y * (1.0 + cosine) / (1.0 + cosine_bd)); // ratio of sines
    const float of_b = cosine - of_d * cosine_bd;
    // Rounding may leave a weight a little below 0. Divided by lengths, they are those of the corners.
    const vec3 weights = max(vec3(of_d * d_of_a, of_b, of_d * d_of_c), 0.0) * opposite;
    return weights.yz / (weights.x + weights.y + weights.z);
}

// Radiance that leaves the point, which depends on it by texture, and by alpha as the share that is there.
vec3 light_triangle_emission(LightRecord light, vec2 barycentric) {
    if (!has_feature(FEATURE_EMISSION_TEXTURES | FEATURE_ALPHA)) return light.radiance;
    // Lanes without a textured light look up the first triangle all the same, and drop the result.
    const bool textured = (light.kind & LIGHT_TEXTURED) != 0u;
    const uint triangle = textured ? light.triangle : 0u;
    const SurfaceCoordinates at = surface_coordinates(triangle, barycentric.x, barycentric.y);
    vec3 looked_up = material_emission(at.material, at.uv0, at.uv1);
    if (has_feature(FEATURE_ALPHA)) looked_up *= material_alpha(at.material, at.uv0, at.uv1, at.color);
    return textured ? looked_up : light.radiance;
}

LightSample light_triangle_sample(LightRecord light, vec3 point, vec2 u) {
    vec2 b = warps_triangle(u);
    float wide_pdf = 0.0;
    if (has_feature(FEATURE_WIDE_TRIANGLES)) {
        const SphericalTriangle seen = light_triangle_seen(point, light.p0, light.p1, light.p2);
        b = light_triangle_barycentric(seen, u);
        wide_pdf = light_triangle_density(seen);
    }
    const vec3 edge1 = light.p1 - light.p0;
    const vec3 edge2 = light.p2 - light.p0;
    const vec3 to_light = light.p0 - point + b.x * edge1 + b.y * edge2;
    const float distance2 = dot(to_light, to_light);
    const float distance = sqrt(distance2);

    LightSample s = light_sample_none();
    s.wi = to_light / distance;
    s.distance = distance;
    s.triangle = light.triangle;
    // Twice the area long: no normal to normalise, and the sign of `facing` tells the side.
    const vec3 normal = cross(edge1, edge2);
    const float facing = -dot(s.wi, normal);
    s.reach = leave_reach(point, point + to_light, distance, normal, facing,
                          leave_error(light.p0, light.p1, light.p2));
    s.pdf = has_feature(FEATURE_WIDE_TRIANGLES) ? wide_pdf : 2.0 * distance2 / abs(facing);
    const bool near = distance2 > LIGHT_NEAR_SQUARED && distance2 <= LIGHT_FAR;
    // Nearer to its plane than rounding, as points of the triangle itself are, the direction is all error.
    const bool valid = near && s.reach > 0.0 && s.pdf > 0.0 && s.pdf <= LIGHT_FAR;
    const bool lit = facing > 0.0 || (light.kind & LIGHT_TWO_SIDED) != 0u;
    s.radiance = valid && lit ? light_triangle_emission(light, b) : vec3(0.0);
    s.pdf = valid ? s.pdf : 0.0;
    s.wi = valid ? s.wi : vec3(0.0, 0.0, 1.0);
    return s;
}

#endif
