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
    vec3 x = uintBitsToFloat(fetch_triangle(base).xyz);
    vec3 y = uintBitsToFloat(fetch_triangle(base + 1u).xyz);
    vec3 z = uintBitsToFloat(fetch_triangle(base + 2u).xyz);
    p0 = vec3(x.x, y.x, z.x);
    p1 = vec3(x.y, y.y, z.y);
    p2 = vec3(x.z, y.z, z.z);
}

// What the test needs of a ray. Axes are permuted so that the direction's largest component is along z; the
// permutation goes into the addresses of the triangle's coordinates, where it costs nothing.
struct TriangleRay {
    vec3 origin;  // permuted
    vec3 shear;   // x, y: slopes along z; z: 1 / component along it
    uvec3 texels; // of a TriangleRecord, for x, y and z
};

TriangleRay triangle_ray(vec3 origin, vec3 direction) {
    TriangleRay ray;
    vec3 size = abs(direction);
    bool main_x = size.x >= size.y && size.x >= size.z;
    bool main_y = !main_x && size.y >= size.z;
    ray.origin = main_x ? origin.yzx : main_y ? origin.zxy : origin;
    ray.texels = main_x ? uvec3(1, 2, 0) : main_y ? uvec3(2, 0, 1) : uvec3(0, 1, 2);
    vec3 d = main_x ? direction.yzx : main_y ? direction.zxy : direction;
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

float triangle_min(float a, float b) { return a < b ? a : b; }
float triangle_max(float a, float b) { return a > b ? a : b; }

// `precise` keeps compilers from fusing one product of a difference, which would break the antisymmetry of
// edges. Vertices coordinate by coordinate, permuted as the ray is.
TriangleHit triangle_test(TriangleRay ray, vec3 vertices_x, vec3 vertices_y, vec3 vertices_z) {
    precise vec3 z = vertices_z - ray.origin.z;
    precise vec3 x = (vertices_x - ray.origin.x) - ray.shear.x * z;
    precise vec3 y = (vertices_y - ray.origin.y) - ray.shear.y * z;
    precise float u = x.z * y.y - y.z * x.y; // weight of the first vertex, and so on
    precise float v = x.x * y.z - y.x * x.z;
    precise float w = x.y * y.x - y.y * x.x;
    precise float determinant = u + v + w;
    precise float t = (u * z.x + v * z.y + w * z.z) * ray.shear.z;
    float inverse = 1.0 / determinant;
    TriangleHit hit;
    hit.t = t * inverse;
    hit.u = v * inverse;
    hit.v = w * inverse;
    // Seen along +z of the sheared frame, which mirrors where the direction's main component is negative.
    hit.back_face = (determinant < 0.0) != (ray.shear.z < 0.0);
    bool same_side = triangle_min(triangle_min(u, v), w) >= 0.0 || triangle_max(triangle_max(u, v), w) <= 0.0;
    // t is a mean of the vertices' depths, so their rounding bounds its error: a t below it may be 0 or
    // negative.
    float reach = triangle_max(abs(z.x), triangle_max(abs(z.y), abs(z.z))) * abs(ray.shear.z);
    hit.inside = same_side && determinant != 0.0 && hit.t > reach * TRIANGLE_T_ERROR;
    return hit;
}

#endif
