// Spheres and suns as a ray meets them. They are in no hierarchy and hide nothing: each ray is tried
// against all of them (MAX_SOFT_LIGHTS), and what costs more than that is done once per light found.
#ifndef AJAR_LIGHTS_SOFT_GLSL
#define AJAR_LIGHTS_SOFT_GLSL
#include "sphere.glsl"
#include "sun.glsl"

// The soft lights, a bit each, that the ray meets nearer than `limit` (metres; LIGHT_FAR: it meets
// nothing). `camera`: the ray comes from there, which sees no lamps.
uvec2 soft_meet(vec3 origin, vec3 direction, float limit, bool camera) {
    uvec2 found = uvec2(0u);
    const uint count = min(frame.soft_count, MAX_SOFT_LIGHTS);
    for (uint i = 0u; i < count; ++i) {
        const uint texel = (frame.soft_first + i) * LIGHT_TEXELS;
        const uvec4 first = fetch_light(texel);
        const vec3 p0 = uintBitsToFloat(first.xyz);
        const float extent = uintBitsToFloat(fetch_light(texel + 3u).w);
        const bool sun = (first.w & LIGHT_KIND_MASK) == LIGHT_SUN;
        const bool lamp = (first.w & LIGHT_LAMP) != 0u;

        const vec3 from_axis = direction - p0;
        const bool in_sun = 0.5 * dot(from_axis, from_axis) <= extent && limit == LIGHT_FAR;

        const vec3 to_center = p0 - origin;
        const float along = dot(to_center, direction);
        const vec3 aside = to_center - along * direction;
        const float aside2 = dot(aside, aside);
        const float outside = dot(to_center, to_center) - extent * extent;
        const bool in_sphere = aside2 <= extent * extent && (outside > 0.0 ? along > 0.0 : lamp) &&
                               light_sphere_distance(along, aside2, extent, outside) < limit;

        const uint bit = (sun ? in_sun : in_sphere) && !(camera && lamp) ? 1u << (i & 31u) : 0u;
        found |= i < 32u ? uvec2(bit, 0u) : uvec2(0u, bit);
    }
    return found;
}

// The limit of a ray that ends on a surface `distance` away. A triangle of a mesh that emits as a sphere
// never hides it, however the distances are rounded.
float soft_limit(float distance, bool part_of_sphere) {
    return part_of_sphere ? distance * (1.0 + SPHERE_SKIN) : distance;
}

// Takes one light out of `found`, which must hold one, and gives the index of its record.
uint soft_next(inout uvec2 found) {
    const bool low = found.x != 0u;
    const uint bit = uint(findLSB(low ? found.x : found.y));
    found.x = low ? found.x & (found.x - 1u) : 0u;
    found.y = low ? found.y : found.y & (found.y - 1u);
    return frame.soft_first + bit + (low ? 0u : 32u);
}

// Radiance of a soft light (rgb) as seen from `point`, and the density (a, 1/sr) with which light_sample
// finds each direction towards it.
vec4 soft_lookup(uint light, vec3 point) {
    const LightRecord record = light_fetch(light);
    if ((record.kind & LIGHT_KIND_MASK) == LIGHT_SUN)
        return vec4(record.radiance, warps_cone_pdf(record.extent));
    const SphereSeen seen = light_sphere_seen(record, point);
    return vec4(light_sphere_radiance(record, seen), seen.pdf);
}

#endif
