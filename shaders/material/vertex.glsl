// A path vertex: the surface at a hit with its material, frame and BSDF, ready to scatter.
#ifndef AJAR_VERTEX_GLSL
#define AJAR_VERTEX_GLSL
#include "../bsdf/bsdf.glsl"
#include "../bsdf/shading_normal.glsl"
#include "../core/frame.glsl"
#include "../core/paths.glsl"
#include "../geometry/surface.glsl"
#include "material.glsl"

struct Vertex {
    Surface surface;
    MaterialPoint material;
    Frame frame;  // local z: shading normal, on the side of wo
    vec3 wo;      // local, towards where the path came from
    Bsdf bsdf;
};

// The vertex that `path` met; path.triangle must not be NO_TRIANGLE.
Vertex vertex_at(PathState path) {
    Vertex v;
    v.surface = surface_at(path.triangle, path.instance, path.u, path.v, path.direction);
    v.material = material_point(v.surface.material, v.surface.uv0, v.surface.uv1, v.surface.color);
    vec3 n = v.surface.n;
    if (has_feature(FEATURE_NORMAL_MAPS)) {
        Frame tangent_frame = frame_from_tangent(n, v.surface.tangent.xyz, v.surface.tangent.w);
        bool mapped = v.surface.tangent.w != 0.0;
        // Seen from behind, n is flipped already; the tangents then belong to the other side's map, as glTF
        // asks.
        n = mapped ? normalize(frame_to_world(tangent_frame, v.material.normal_ts)) : n;
    }
    n = shading_normal_adapt(n, v.surface.ng, -path.direction);
    v.frame = frame_make(n);
    v.wo = frame_to_local(v.frame, -path.direction);
    v.bsdf = bsdf_make(v.material);
    return v;
}

// Radiance the surface itself sends along wo: its emission, or an unlit material's colour.
vec3 vertex_emission(Vertex v) {
    bool faces = !v.surface.back_face || (v.material.flags & MATERIAL_DOUBLE_SIDED) != 0u;
    vec3 radiance = faces && v.surface.emits ? v.material.emission : vec3(0.0);
    bool unlit = has_feature(FEATURE_UNLIT) && (v.material.flags & MATERIAL_UNLIT) != 0u;
    return unlit && v.surface.emits ? v.material.base_color.rgb : radiance;
}

#endif
