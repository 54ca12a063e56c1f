// Points on surface elements (element.glsl.h).
#ifndef AJAR_ELEMENT_GLSL
#define AJAR_ELEMENT_GLSL
#include "../core/warps.glsl"
#include "../shared/element.glsl.h"
#include "triangle.glsl"

// Barycentrics (weights of the second and third vertex) of a point, uniform over the element.
vec2 element_point(SurfaceElement element, vec2 u) {
    vec2 w = (element.flags & ELEMENT_QUAD) != 0u ? u : warps_triangle(u);
    vec2 at = max(element.origin + w.x * element.edge_a + w.y * element.edge_b, vec2(0.0));
    // Beyond the longest side, or there by rounding.
    float sum = at.x + at.y;
    return sum > 1.0 ? at / sum : at;
}

// The element's geometric normal: world, unit, to its side; zero where the triangle has no area.
vec3 element_normal(SurfaceElement element) {
    vec3 p0;
    vec3 p1;
    vec3 p2;
    triangle_vertices(element.triangle, p0, p1, p2);
    vec3 cross_edges = cross(p1 - p0, p2 - p0);
    vec3 front = cross_edges / max(length(cross_edges), 1e-37);
    return (element.flags & ELEMENT_BACK) != 0u ? -front : front;
}

#endif
