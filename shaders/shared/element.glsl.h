// Surface elements: pieces of triangles from which paths begin, to bake light or to solve for it.
#ifndef AJAR_ELEMENT_GLSL_H
#define AJAR_ELEMENT_GLSL_H
#include "dual.glsl.h"
DUAL_BEGIN

const uint ELEMENT_BACK = 1u << 0; // the triangle's back side
const uint ELEMENT_QUAD = 1u << 1; // a parallelogram; else a triangle

// Barycentrics (u, v) are weights of the triangle's second and third vertex. Where a piece reaches beyond the
// triangle its points are moved to the border.
struct SurfaceElement {
    uint triangle; // in leaf order; of instance 0, the world
    uint flags;    // ELEMENT_*
    vec2 origin;   // (u, v) of its first corner
    vec2 edge_a;   // from there to its second
    vec2 edge_b;   // and to its third; a parallelogram's fourth lies opposite the first
};
DUAL_SIZE(SurfaceElement, 32);
DUAL_PTR(SurfaceElement);

DUAL_END
#endif
