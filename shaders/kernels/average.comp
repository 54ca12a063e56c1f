// Emission and reflectance of patches; see average.glsl.h.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "average.glsl.h"
#include "../core/sampler.glsl"
#include "../core/workgroup.glsl"
#include "../geometry/element.glsl"
#include "../material/vertex.glsl"

layout(push_constant, scalar) uniform ArgsBlock { AverageArgs args; };

const uint MAX_POINTS = 4096u;

void main() {
    uint i = workgroup_index() * WORKGROUP_SIZE + gl_LocalInvocationID.x;
    if (i >= args.side_count) return;
    uint side = args.first_side + i;
    SurfaceElement element = args.elements.at[side];
    Frame facing = frame_make(element_normal(element));
    vec3 emission = vec3(0.0);
    vec3 reflectance = vec3(0.0);
    float there = 0.0;
    for (uint k = 0u; k < min(args.points, MAX_POINTS); ++k) {
        Sampler points = sampler_begin(frame.seed, side, k, frame.sequence_log2);
        vec2 at = element_point(element, sampler_2d(points, DIM_PIXEL));
        PathState path;
        path.triangle = element.triangle;
        path.instance = 0u;
        path.u = at.x;
        path.v = at.y;
        path.direction = -frame_to_world(facing, warps_cosine_hemisphere(sampler_2d(points, DIM_LENS)));
        Vertex v = vertex_at(path);
        float alpha = v.material.base_color.a;
        there += alpha;
        emission += alpha * vertex_emission(v);
        uint dimension = sampler_bounce(0u);
        float u_lobe = has_feature(FEATURE_SPECULAR) ? sampler_1d(points, dimension + DIM_BSDF_LOBE) : 0.0;
        BsdfSample next = bsdf_sample(v.bsdf, v.wo, sampler_2d(points, dimension + DIM_BSDF), u_lobe);
        // Lambert's albedo has no direction to lose below a bent normal's horizon.
        bool scatters = !has_feature(FEATURE_SPECULAR) ||
                        dot(frame_to_world(v.frame, next.wi), v.surface.ng) > 0.0;
        bool unlit = has_feature(FEATURE_UNLIT) && (v.material.flags & MATERIAL_UNLIT) != 0u;
        reflectance += scatters && !unlit ? alpha * next.weight : vec3(0.0);
    }
    float inverse = there > 0.0 ? 1.0 / there : 0.0;
    float points_inverse = 1.0 / float(int(args.points));
    args.emission.at[side].rgb = emission * inverse;
    args.emission.at[side].scalar = there * points_inverse;
    args.reflectance.at[side].rgb = clamp(reflectance * inverse, 0.0, 1.0);
}
