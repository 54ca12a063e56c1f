// Emissive triangle: a point uniform by area, its density carried over to solid angle, pdf = d^2 / (A |cos|).
// Sampling by solid angle (Arvo 1995) would replace light_triangle_sample and light_pdf_triangle alone.
#ifndef AJAR_LIGHTS_TRIANGLE_GLSL
#define AJAR_LIGHTS_TRIANGLE_GLSL
#include "../core/warps.glsl"
#include "../geometry/leave.glsl"
#include "../geometry/surface.glsl"
#include "../material/material.glsl"
#include "light_sample.glsl"

// Density by solid angle (1/sr) with which light_triangle_sample finds the point that a ray along the unit
// vector `direction` meets at `distance` (metres) on a triangle of unit geometric normal ng and that area
// (m^2). 0 for rays in the triangle's plane: those are never sampled.
float light_pdf_triangle(vec3 direction, float distance, vec3 ng, float area) {
    const float projected = abs(dot(direction, ng)) * area;
    const float pdf = distance * distance / projected;
    return projected > 0.0 && pdf <= LIGHT_FAR ? pdf : 0.0;
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
    const vec2 b = warps_triangle(u);
    const vec3 edge1 = light.p1 - light.p0;
    const vec3 edge2 = light.p2 - light.p0;
    const vec3 to_light = light.p0 + b.x * edge1 + b.y * edge2 - point;
    const float distance2 = dot(to_light, to_light);
    const float distance = sqrt(distance2);

    LightSample s = light_sample_none();
    s.wi = to_light / distance;
    s.distance = distance;
    s.triangle = light.triangle;
    // Twice the area long, so that `facing` is 2 A cos: no normal to normalise, and its sign tells the side.
    const vec3 normal = cross(edge1, edge2);
    const float facing = -dot(s.wi, normal);
    s.reach = leave_reach(point, point + to_light, distance, normal, facing,
                          leave_error(light.p0, light.p1, light.p2));
    s.pdf = 2.0 * distance2 / abs(facing);
    const bool valid = distance2 > LIGHT_NEAR_SQUARED && facing != 0.0 && s.pdf > 0.0 && s.pdf <= LIGHT_FAR;
    const bool lit = facing > 0.0 || (light.kind & LIGHT_TWO_SIDED) != 0u;
    s.radiance = valid && lit ? light_triangle_emission(light, b) : vec3(0.0);
    s.pdf = valid ? s.pdf : 0.0;
    s.wi = valid ? s.wi : vec3(0.0, 0.0, 1.0);
    return s;
}

#endif
