// Whether a surface is there at all at a candidate hit: glTF alphaMode MASK and BLEND, and back-face culling.
// BLEND is stochastic: alpha is the probability of being there, decided by a hash of the ray's salt and the
// triangle, so that the order in which candidates come up does not matter.
#ifndef AJAR_ALPHA_GLSL
#define AJAR_ALPHA_GLSL
#include "../core/rng.glsl"
#include "../material/material.glsl"
#include "surface.glsl"

bool alpha_passes(uint triangle, uint instance, float u, float v, bool back_face, uint salt) {
    SurfaceCoordinates s = surface_coordinates(triangle, u, v);
    // MASK gives coverage 0 or 1, where the coin does not matter.
    bool there = rng_salted_float(salt, triangle, instance) < material_alpha(s.material, s.uv0, s.uv1,
        s.color);
    uint flags = fetch_material(s.material * MATERIAL_TEXELS + 1u).w;
    bool culled = frame.cull_backfaces != 0u && back_face && (flags & MATERIAL_DOUBLE_SIDED) == 0u;
    return there && !culled;
}

#endif
