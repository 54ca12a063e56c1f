// Watertight ray-triangle intersection: Woop, Benthin and Wald 2013, "Watertight Ray/Triangle Intersection".
// A vertex is sheared into the ray's frame the same way in every triangle that shares it, so the sign of an
// edge function is the same on both sides of an edge and no ray passes between two triangles. Edges count as
// inside.
#ifndef AJAR_TRIANGLE_GLSL
#define AJAR_TRIANGLE_GLSL
#include "../core/tables.glsl"
#include "../shared/bvh.glsl.h"

void triangle_vertices(uint triangle, out vec3 p0, out vec3 p1, out vec3 p2) {
    uint base = triangle * TRIANGLE_TEXELS;
    p0 = uintBitsToFloat(fetch_triangle(base).xyz);
    p1 = uintBitsToFloat(fetch_triangle(base + 1u).xyz);
    p2 = uintBitsToFloat(fetch_triangle(base + 2u).xyz);
}

// What the test needs of a ray: its origin, and the shear that turns its direction to +z of permuted axes.
struct TriangleRay {
    vec3 origin;
    vec3 shear;     // x, y: slopes along the main axis; z: 1 / component along it
    bool main_x;    // the axis of the direction's largest component; neither: z
    bool main_y;
};

vec3 triangle_permute(TriangleRay ray, vec3 v) {
    return vec3(ray.main_x ? v.y : ray.main_y ? v.z : v.x,
                ray.main_x ? v.z : ray.main_y ? v.x : v.y,
                ray.main_x ? v.x : ray.main_y ? v.y : v.z);
}

TriangleRay triangle_ray(vec3 origin, vec3 direction) {
    TriangleRay ray;
    vec3 size = abs(direction);
    ray.origin = origin;
    ray.main_x = size.x >= size.y && size.x >= size.z;
    ray.main_y = !ray.main_x && size.y >= size.z;
    vec3 d = triangle_permute(ray, direction);
    ray.shear = vec3(d.x / d.z, d.y / d.z, 1.0 / d.z);
    return ray;
}

struct TriangleHit {
    bool inside; // the line meets the triangle in front of the origin
    float t;
    float u;
    float v;
    bool back_face;
};

// `precise` keeps compilers from fusing one product of a difference, which would break the antisymmetry of
// edges.
TriangleHit triangle_test(TriangleRay ray, vec3 p0, vec3 p1, vec3 p2) {
    vec3 a = triangle_permute(ray, p0 - ray.origin);
    vec3 b = triangle_permute(ray, p1 - ray.origin);
    vec3 c = triangle_permute(ray, p2 - ray.origin);
    precise vec2 as = a.xy - ray.shear.xy * a.z;
    precise vec2 bs = b.xy - ray.shear.xy * b.z;
    precise vec2 cs = c.xy - ray.shear.xy * c.z;
    precise float u = cs.x * bs.y - cs.y * bs.x; // weight of p0, and so on
    precise float v = as.x * cs.y - as.y * cs.x;
    precise float w = bs.x * as.y - bs.y * as.x;
    precise float determinant = u + v + w;
    precise float t = (u * a.z + v * b.z + w * c.z) * ray.shear.z;
    float inverse = 1.0 / determinant;
    TriangleHit hit;
    hit.t = t * inverse;
    hit.u = v * inverse;
    hit.v = w * inverse;
    // Seen along +z of the sheared frame, which mirrors where the direction's main component is negative.
    hit.back_face = (determinant < 0.0) != (ray.shear.z < 0.0);
    bool same_side = (u >= 0.0 && v >= 0.0 && w >= 0.0) || (u <= 0.0 && v <= 0.0 && w <= 0.0);
    // t is a mean of the vertices' depths, so their rounding bounds its error: a t below it may be 0 or
    // negative.
    float reach = max(abs(a.z), max(abs(b.z), abs(c.z))) * abs(ray.shear.z);
    hit.inside = same_side && determinant != 0.0 && hit.t > reach * TRIANGLE_T_ERROR;
    return hit;
}

#endif
