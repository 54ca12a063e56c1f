// Where a ray really starts and ends: off the triangle it leaves, and short of the one it aims at, by the
// rounding errors of both points, so that it can meet neither of them nor a coplanar neighbour. Distances
// follow from the coordinates' size in floating point; no scale of the scene enters. After Pharr, Jakob and
// Humphreys, "Physically Based Rendering", 3rd edition, section 3.9.
#ifndef AJAR_LEAVE_GLSL
#define AJAR_LEAVE_GLSL
#include "../core/tables.glsl"
#include "../shared/geometry.glsl.h"

// Interpolation rounds four times, adding the offset once: five units of 2^-24. Eight leave some to the
// shading code.
const float LEAVE_ROUNDING = 4.7683716e-7;

vec3 leave_max(vec3 a, vec3 b) {
    return vec3(a.x < b.x ? b.x : a.x, a.y < b.y ? b.y : a.y, a.z < b.z ? b.z : a.z);
}

// How far, per axis, a point computed on the triangle may be off, metres.
vec3 leave_error(vec3 p0, vec3 p1, vec3 p2) {
    return leave_max(abs(p0), leave_max(abs(p1), abs(p2))) * LEAVE_ROUNDING;
}

// The same in the world for a point on an instance's triangle, whose vertices are given in its own frame: the
// vertices' way to the world, and the ray's way to the object, seen in the world.
vec3 leave_error_instanced(vec3 p0, vec3 p1, vec3 p2, uint instance, vec3 point) {
    vec3 size = leave_max(abs(p0), leave_max(abs(p1), abs(p2)));
    vec4 m[6];
    for (uint i = 0u; i < 6u; ++i)
        m[i] = abs(uintBitsToFloat(fetch_instance(instance * INSTANCE_TEXELS + i)));
    vec4 from = vec4(abs(point), 1.0);
    size += vec3(dot(m[3], from), dot(m[4], from), dot(m[5], from));
    vec4 back = vec4(size, 1.0);
    return vec3(dot(m[0], back), dot(m[1], back), dot(m[2], back)) * LEAVE_ROUNDING;
}

// The way from a computed point to one that is surely on the side of the triangle's plane to which its unit
// normal shows.
vec3 leave_offset(vec3 normal, vec3 error) { return normal * dot(abs(normal), error); }

// The part of the way from `origin` to a point on a triangle that something can block. `normal`: the
// triangle's, of any length; `facing`: the cosine to it, of that same length; `error`: leave_error.
float leave_reach(vec3 origin, vec3 target, float distance, vec3 normal, float facing, vec3 error) {
    vec3 both = error + LEAVE_ROUNDING * (abs(origin) + abs(target));
    float reach = distance - distance * LEAVE_ROUNDING - dot(abs(normal), both) / abs(facing);
    return reach > 0.0 ? reach : 0.0; // NaN, for a ray in the plane, too
}

#endif
