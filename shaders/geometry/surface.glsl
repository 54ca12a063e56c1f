// The surface at a hit: position, frames and attributes, from BIND_TRIANGLES and BIND_SURFACES.
#ifndef AJAR_SURFACE_GLSL
#define AJAR_SURFACE_GLSL
#include "../core/octahedral.glsl"
#include "../core/tables.glsl"
#include "../shared/geometry.glsl.h"
#include "leave.glsl"
#include "triangle.glsl"

struct Surface {
    vec3 position;    // world, metres
    vec3 departure;   // where rays to ng's side start: off the triangle by the rounding error (leave.glsl)
    vec3 ng;          // geometric normal, world, unit, on the side the ray came from
    vec3 n;           // interpolated shading normal, world, unit, turned with ng
    vec4 tangent;     // world; w: handedness; zero where the mesh has none
    vec2 uv0;
    vec2 uv1;
    vec4 color;       // vertex colour, linear RGBA
    uint material;
    uint light;       // LightRecord this triangle is, or NO_LIGHT
    uint object;      // index in Scene::instances
    bool emits;       // false: its mesh emits as a sphere instead, which rays meet elsewhere
    bool back_face;
};

struct SurfaceCoordinates {
    vec2 uv0;
    vec2 uv1;
    vec4 color;
    uint material;
};

vec3 surface_weights(float u, float v) { return vec3(1.0 - u - v, u, v); }

uint surface_stride() {
    return has_feature(FEATURE_EXTENDED_SURFACE) ? SURFACE_EXTENDED_TEXELS : SURFACE_TEXELS;
}

vec4 surface_vertex_color(uint low, uint high) { return vec4(unpackUnorm2x16(low), unpackUnorm2x16(high)); }

// What textures need, without the frames: for alpha tests and textured emission.
SurfaceCoordinates surface_coordinates(uint triangle, float u, float v) {
    vec3 w = surface_weights(u, v);
    uint base = triangle * surface_stride();
    uvec4 a = fetch_surface(base);
    uvec4 b = fetch_surface(base + 1u);
    uvec4 c = fetch_surface(base + 2u);
    SurfaceCoordinates s;
    s.material = a.w;
    s.uv0 = w.x * uintBitsToFloat(b.xy) + w.y * uintBitsToFloat(b.zw) + w.z * uintBitsToFloat(c.xy);
    s.uv1 = s.uv0;
    s.color = vec4(1.0);
    if (has_feature(FEATURE_EXTENDED_SURFACE)) {
        uvec4 d = fetch_surface(base + 3u);
        uvec4 e = fetch_surface(base + 4u);
        uvec4 f = fetch_surface(base + 5u);
        uvec4 g = fetch_surface(base + 6u);
        s.uv1 = w.x * uintBitsToFloat(d.xy) + w.y * uintBitsToFloat(d.zw) + w.z * uintBitsToFloat(e.xy);
        s.color = w.x * surface_vertex_color(f.z, f.w) + w.y * surface_vertex_color(g.x, g.y) +
                  w.z * surface_vertex_color(g.z, g.w);
    }
    return s;
}

// A vector as columns' combination: normals go by the inverse transpose.
vec3 surface_normal_to_world(uint instance, vec3 n) {
    uint base = instance * INSTANCE_TEXELS + 3u;
    return n.x * uintBitsToFloat(fetch_instance(base)).xyz + n.y * uintBitsToFloat(fetch_instance(base +
        1u)).xyz +
           n.z * uintBitsToFloat(fetch_instance(base + 2u)).xyz;
}

vec3 surface_point_to_world(uint instance, vec4 p) {
    uint base = instance * INSTANCE_TEXELS;
    return vec3(dot(uintBitsToFloat(fetch_instance(base)), p), dot(uintBitsToFloat(fetch_instance(base +
        1u)), p),
                dot(uintBitsToFloat(fetch_instance(base + 2u)), p));
}

// The surface where a ray of that direction met the triangle at barycentrics (u, v).
Surface surface_at(uint triangle, uint instance, float u, float v, vec3 direction) {
    Surface s;
    vec3 w = surface_weights(u, v);
    vec3 p0;
    vec3 p1;
    vec3 p2;
    triangle_vertices(triangle, p0, p1, p2);
    uint base = triangle * surface_stride();
    uvec4 a = fetch_surface(base);
    uvec4 b = fetch_surface(base + 1u);
    uvec4 c = fetch_surface(base + 2u);
    vec3 n = w.x * octahedral_decode(a.x) + w.y * octahedral_decode(a.y) + w.z * octahedral_decode(a.z);
    s.material = a.w;
    s.uv0 = w.x * uintBitsToFloat(b.xy) + w.y * uintBitsToFloat(b.zw) + w.z * uintBitsToFloat(c.xy);
    s.emits = !has_feature(FEATURE_SOFT_LIGHTS) || c.z != LIGHT_ELSEWHERE;
    s.light = s.emits ? c.z : NO_LIGHT;
    s.object = c.w;
    s.uv1 = s.uv0;
    s.color = vec4(1.0);
    s.tangent = vec4(0.0);
    if (has_feature(FEATURE_EXTENDED_SURFACE)) {
        uvec4 d = fetch_surface(base + 3u);
        uvec4 e = fetch_surface(base + 4u);
        uvec4 f = fetch_surface(base + 5u);
        uvec4 g = fetch_surface(base + 6u);
        s.uv1 = w.x * uintBitsToFloat(d.xy) + w.y * uintBitsToFloat(d.zw) + w.z * uintBitsToFloat(e.xy);
        s.color = w.x * surface_vertex_color(f.z, f.w) + w.y * surface_vertex_color(g.x, g.y) +
                  w.z * surface_vertex_color(g.z, g.w);
        vec3 t = w.x * octahedral_decode(e.z) + w.y * octahedral_decode(e.w) + w.z * octahedral_decode(f.x);
        s.tangent = (f.y & 8u) != 0u ? vec4(t, (f.y & 1u) != 0u ? -1.0 : 1.0) : vec4(0.0);
    }
    vec3 o0 = p0, o1 = p1, o2 = p2; // in the object's frame
    bool flipped = false;
    if (has_feature(FEATURE_INSTANCES)) {
        p0 = surface_point_to_world(instance, vec4(p0, 1.0));
        p1 = surface_point_to_world(instance, vec4(p1, 1.0));
        p2 = surface_point_to_world(instance, vec4(p2, 1.0));
        n = surface_normal_to_world(instance, n);
        s.tangent.xyz = surface_point_to_world(instance, vec4(s.tangent.xyz, 0.0));
        uvec4 tail = fetch_instance(instance * INSTANCE_TEXELS + 6u);
        flipped = (tail.y & INSTANCE_FLIPPED) != 0u;
        s.tangent.w = flipped ? -s.tangent.w : s.tangent.w;
        s.object = instance == 0u ? s.object : tail.z;
    }
    s.position = w.x * p0 + w.y * p1 + w.z * p2;
    vec3 cross_edges = cross(p1 - p0, p2 - p0);
    float twice_area = length(cross_edges);
    s.ng = cross_edges / max(twice_area, 1e-37);
    s.ng = flipped ? -s.ng : s.ng;
    float length2 = dot(n, n);
    s.n = length2 > 0.0 ? n * inversesqrt(length2) : s.ng;
    // Front faces are counter-clockwise. Both normals turn to the ray's side; vertex normals are trusted to
    // agree with the winding only in sign.
    s.back_face = dot(s.ng, direction) > 0.0;
    s.ng = s.back_face ? -s.ng : s.ng;
    s.n = dot(s.n, s.ng) < 0.0 ? -s.n : s.n;
    vec3 error = has_feature(FEATURE_INSTANCES) ? leave_error_instanced(o0, o1, o2, instance, s.position)
                                                : leave_error(p0, p1, p2);
    s.departure = s.position + leave_offset(s.ng, error);
    return s;
}

#endif
