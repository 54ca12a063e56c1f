// The lecture's first path tracer; see naive.glsl.h.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "naive.glsl.h"
#include "../core/paths.glsl"
#include "../core/sampler.glsl"
#include "../core/segment.glsl"
#include "../core/scan.glsl"
#include "../core/warps.glsl"
#include "../lights/environment.glsl"
#include "../lights/soft.glsl"
#include "../material/vertex.glsl"

layout(push_constant, scalar) uniform ArgsBlock { NaiveArgs args; };

BsdfSample sample_direction(Vertex v, Sampler points, uint dimension) {
    vec2 u = sampler_2d(points, dimension + DIM_BSDF);
    if (OPTION == NAIVE_BSDF) return bsdf_sample(v.bsdf, v.wo, u, sampler_1d(points, dimension +
        DIM_BSDF_LOBE));
    vec3 wi = warps_cosine_hemisphere(u);
    // f cos / (cos / pi): the cosines cancel.
    return BsdfSample(wi, bsdf_eval(v.bsdf, v.wo, wi) * MATH_PI, warps_cosine_hemisphere_pdf(wi.z), false);
}

// Spheres and suns, which are in no hierarchy; `limit`: where the ray ends.
vec3 met_soft_lights(PathState path, float limit) {
    vec3 sum = vec3(0.0);
    uvec2 found = soft_meet(path.origin, path.direction, limit, args.segments.bounce == 0u);
    while (any(notEqual(found, uvec2(0u)))) sum += soft_lookup(soft_next(found), path.origin).rgb;
    return sum;
}

// False when the path ends here.
bool bounce(inout PathState path) {
    bool alive = false;
    vec3 beta = path.beta;
    vec3 emission;
    PathState arrived = path;
    float limit = LIGHT_FAR;
    if (path.triangle == NO_TRIANGLE) {
        emission = environment_radiance(path.direction);
    } else {
        Vertex v = vertex_at(path);
        emission = vertex_emission(v);
        limit = soft_limit(length(v.surface.position - path.origin), !v.surface.emits);
        bool lit = !has_feature(FEATURE_UNLIT) || (v.material.flags & MATERIAL_UNLIT) == 0u;
        if (args.segments.bounce <= frame.max_bounces && lit) {
            Sampler points = segment_sampler(args.segments, path.home);
            uint dimension = sampler_bounce(args.segments.bounce);
            BsdfSample next = sample_direction(v, points, dimension);
            path.origin = v.surface.departure;
            path.leaves = path.triangle;
            path.direction = frame_to_world(v.frame, next.wi);
            path.beta *= next.weight;
            alive = any(greaterThan(path.beta, vec3(0.0))) && dot(path.direction, v.surface.ng) > 0.0;
            if (args.segments.bounce >= frame.rr_depth) {
                float survival = min(math_max3(path.beta), 1.0);
                alive = alive && sampler_1d(points, dimension + DIM_ROULETTE) < survival;
                path.beta /= survival;
            }
        }
    }
    if (has_feature(FEATURE_SOFT_LIGHTS)) emission += met_soft_lights(arrived, limit);
    if (any(notEqual(emission, vec3(0.0)))) radiance_add(path.home, beta * emission);
    return alive;
}

void main() {
    uint segment = segment_index(args.segments);
    if (segment == NO_SEGMENT) return;
    uint first = segment * SEGMENT_SIZE;
    uint count = segments[segment].paths;
    uint kept = 0u;
    for (uint base = 0u; base < count; base += WORKGROUP_SIZE) {
        uint i = base + gl_LocalInvocationID.x;
        PathState path = path_load(first + min(i, count - 1u));
        bool alive = false;
        if (i < count) alive = bounce(path);
        Scan survivors = scan_keepers(alive);
        path_store(first + kept + scan_place(survivors, alive), path);
        kept += survivors.total;
    }
    if (gl_LocalInvocationID.x == 0u) segments[segment].paths = kept;
}
