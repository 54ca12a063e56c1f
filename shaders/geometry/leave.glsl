// Where a ray really starts: moved off the triangle it leaves by the rounding error of its origin, so that it
// cannot meet a coplanar neighbour. The distance follows from the coordinates' size in floating point; no
// scale of the scene enters. After Pharr, Jakob and Humphreys, "Physically Based Rendering", 3rd edition,
// section 3.9.
#ifndef AJAR_LEAVE_GLSL
#define AJAR_LEAVE_GLSL
#include "../shared/geometry.glsl.h"
#include "../shared/path.glsl.h"
#include "triangle.glsl"

// A plane through a triangle and how far, per axis, a point computed on it may be off.
struct LeavePlane {
    vec3 normal; // world, its largest component about 1; zero for a degenerate triangle
    vec3 error;  // world, metres
};

vec3 leave_max(vec3 a, vec3 b) {
    return vec3(a.x < b.x ? b.x : a.x, a.y < b.y ? b.y : a.y, a.z < b.z ? b.z : a.z);
}

// Interpolation rounds four times, adding the offset once: five units of 2^-24. Eight leave some to the
// shading code.
const float LEAVE_ROUNDING = 4.7683716e-7;

LeavePlane leave_plane(uint triangle, uint instance, vec3 point) {
    vec3 p0, p1, p2;
    triangle_vertices(triangle, p0, p1, p2);
    vec3 normal = cross(p1 - p0, p2 - p0);
    vec3 size = leave_max(abs(p0), leave_max(abs(p1), abs(p2)));
    if (has_feature(FEATURE_INSTANCES)) {
        vec4 m[6];
        for (uint i = 0u; i < 6u; ++i) m[i] = uintBitsToFloat(fetch_instance(instance * INSTANCE_TEXELS + i));
        normal = normal.x * m[3].xyz + normal.y * m[4].xyz + normal.z * m[5].xyz;
        // The vertices' way to the world, and the ray's way to the object, both seen in the world.
        vec3 back =
            vec3(dot(abs(m[3].xyz), abs(point)) + abs(m[3].w), dot(abs(m[4].xyz), abs(point)) + abs(m[4].w),
                 dot(abs(m[5].xyz), abs(point)) + abs(m[5].w));
        size += back;
        size = vec3(dot(abs(m[0].xyz), size) + abs(m[0].w), dot(abs(m[1].xyz), size) + abs(m[1].w),
                    dot(abs(m[2].xyz), size) + abs(m[2].w));
    }
    float largest = max(abs(normal.x), max(abs(normal.y), abs(normal.z)));
    LeavePlane plane;
    plane.normal = largest > 0.0 ? normal / largest : vec3(0.0);
    plane.error = size * LEAVE_ROUNDING;
    return plane;
}

// The way from the computed origin to one that is surely on the side the ray goes to.
vec3 leave_offset(uint triangle, uint instance, vec3 origin, vec3 direction) {
    bool leaves = triangle != NO_TRIANGLE;
    LeavePlane plane = leave_plane(leaves ? triangle : 0u, leaves ? instance : 0u, origin);
    float amount = dot(abs(plane.normal), plane.error) / max(dot(plane.normal, plane.normal), 1.0);
    float side = dot(plane.normal, direction) < 0.0 ? -amount : amount;
    return leaves ? plane.normal * side : vec3(0.0);
}

// The part of the way to a light that can be blocked: not what lies within the rounding errors of the light's
// plane.
float leave_reach(float distance, uint light_triangle, uint light_instance, vec3 origin, vec3 direction,
                  vec3 offset) {
    float reach = distance - distance * LEAVE_ROUNDING;
    if (has_feature(FEATURE_EMISSIVE_TRIANGLES)) {
        bool aims = light_triangle != NO_TRIANGLE;
        vec3 target = origin + direction * distance;
        LeavePlane plane = leave_plane(aims ? light_triangle : 0u, aims ? light_instance : 0u, target);
        // The target and the origin it was measured from carry an error each.
        vec3 error = plane.error + LEAVE_ROUNDING * (abs(origin) + abs(target));
        float margin = dot(abs(plane.normal), error) + abs(dot(plane.normal, offset));
        float cosine = abs(dot(plane.normal, direction));
        reach = aims ? (margin < cosine * reach ? reach - margin / cosine : 0.0) : reach;
    }
    return reach;
}

#endif
