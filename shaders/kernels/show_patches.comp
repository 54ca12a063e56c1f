// Shows what radiosity found; see show_patches.glsl.h.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "show_patches.glsl.h"
#include "../core/paths.glsl"
#include "../core/sampler.glsl"
#include "../core/segment.glsl"
#include "../lights/met.glsl"
#include "../material/vertex.glsl"
#include "../radiosity/patch_light.glsl"

layout(push_constant, scalar) uniform ArgsBlock { ShowPatchesArgs args; };

// rho(wo) of the point, on average.
vec3 reflectance(PathState path, Vertex v) {
    Sampler points = segment_sampler(args.segments, path.home);
    uint dimension = sampler_bounce(args.segments.bounce);
    float u_lobe = has_feature(FEATURE_SPECULAR) ? sampler_1d(points, dimension + DIM_BSDF_LOBE) : 0.0;
    vec3 weight = bsdf_sample(v.bsdf, v.wo, sampler_2d(points, dimension + DIM_BSDF), u_lobe).weight;
    bool lit = !has_feature(FEATURE_UNLIT) || (v.material.flags & MATERIAL_UNLIT) == 0u;
    return lit ? weight : vec3(0.0);
}

// Of a surface that the path met; `limit`: how far away it is, to what lies before it.
vec3 surface_radiance(PathState path, uvec2 left, MetWay way, out float limit) {
    Vertex v = vertex_at(path);
    limit = soft_limit(length(v.surface.position - path.origin), !v.surface.emits);
    PatchHit hit = patch_lookup(path.triangle, path.u, path.v);
    bool found = hit.index != PATCH_NONE;
    uint side = found ? patch_side(hit.index, v.surface.back_face) : 0u;
    vec3 light;
    if (OPTION == SHOW_FLAT) light = patch_radiance(side);
    else light = patch_irradiance(side, hit.u, hit.v) * reflectance(path, v) * MATH_INV_PI;
    light = found ? light : vec3(0.0);
    return OPTION == SHOW_FLAT ? light : light + met_surface(path, left, v, way);
}

void main() {
    uint segment = segment_index(args.segments);
    if (segment == NO_SEGMENT) return;
    uint first = segment * SEGMENT_SIZE;
    uint count = segments[segment].paths;
    for (uint i = gl_LocalInvocationID.x; i < count; i += WORKGROUP_SIZE) {
        PathState path = path_load(first + i);
        uvec2 left = met_left(path);
        MetWay way = MetWay(args.segments.bounce == 0u, false);
        float limit = LIGHT_FAR;
        vec3 light;
        if (path.triangle == NO_TRIANGLE) light = met_environment(path, left, way);
        else light = surface_radiance(path, left, way, limit);
        if (has_feature(FEATURE_SOFT_LIGHTS)) light += met_soft_lights(path, left, limit, way);
        radiance_add(path.home, path.beta * light);
    }
    if (gl_LocalInvocationID.x == 0u) segments[segment].paths = 0u;
}
