// Scene tables about triangles and instances. The hierarchy's own layout is in bvh.glsl.h.
#ifndef AJAR_GEOMETRY_GLSL_H
#define AJAR_GEOMETRY_GLSL_H
#include "dual.glsl.h"
DUAL_BEGIN

// BIND_SURFACES: per triangle, in leaf order like BIND_TRIANGLES: what shading needs at a hit.
// Unit vectors are octahedral, 2 x snorm16 (Cigolla et al. 2014). Stride: SURFACE_TEXELS or
// SURFACE_EXTENDED_TEXELS.
struct SurfaceRecord {
    uint normal[3];   // vertex normals, the frame of the triangle's positions
    uint material;    // index of the MaterialRecord
    vec2 uv0[3];
    uint light;       // index of the LightRecord this triangle is, NO_LIGHT or LIGHT_ELSEWHERE
    uint object;      // index in Scene::instances of what was baked into the world; else see InstanceRecord
};
DUAL_SIZE(SurfaceRecord, 48);

// Follows each SurfaceRecord where FEATURE_EXTENDED_SURFACE is set.
struct SurfaceExtension {
    vec2 uv1[3];
    uint tangent[3];  // octahedral tangent
    uint tangent_sign; // bit k: the bitangent of vertex k is -cross(n, t); bit 3: tangents are present
    uint color[6];    // per vertex RGBA, 2 x unorm16 per word
};
DUAL_SIZE(SurfaceExtension, 64);

const uint SURFACE_TEXELS = 3;
const uint SURFACE_EXTENDED_TEXELS = 7;
const uint NO_LIGHT = 0xffffffffu;
const uint LIGHT_ELSEWHERE = 0xfffffffeu; // part of a mesh that emits as an analytic sphere (LIGHT_SPHERE)

// BIND_INSTANCES. Instance 0 is the world itself (identity): all meshes that are used once, baked into world
// space.
struct InstanceRecord {
    vec4 to_world[3];  // rows of the 3 x 4 matrix
    vec4 to_object[3]; // rows of its inverse
    uint root;         // node index of the mesh's hierarchy
    uint flags;        // INSTANCE_*
    uint object;       // index in Scene::instances; instance 0: see SurfaceRecord::object
    uint pad;
};
DUAL_SIZE(InstanceRecord, 112);

const uint INSTANCE_TEXELS = 7;
const uint INSTANCE_FLIPPED = 1; // negative determinant: winding and facing are flipped

DUAL_END
#endif
