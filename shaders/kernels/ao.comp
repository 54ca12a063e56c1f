// Ambient occlusion; see ao.glsl.h.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "ao.glsl.h"
#include "../core/paths.glsl"
#include "../core/sampler.glsl"
#include "../core/segment.glsl"
#include "../core/scan.glsl"
#include "../core/warps.glsl"
#include "../material/vertex.glsl"

layout(push_constant, scalar) uniform ArgsBlock { AoArgs args; };

ShadowRay occlusion_ray(PathState path) {
    Vertex v = vertex_at(path);
    Sampler points = segment_sampler(args.segments, path.home);
    vec3 wi = warps_cosine_hemisphere(sampler_2d(points, sampler_bounce(0u) + DIM_BSDF));
    ShadowRay ray;
    ray.origin = v.surface.departure;
    ray.leaves = path.triangle;
    ray.direction = frame_to_world(v.frame, wi);
    ray.reach = frame.ao_distance;
    // A direction below the geometric surface is blocked by that surface.
    ray.contribution = vec3(dot(ray.direction, v.surface.ng) > 0.0 ? 1.0 : 0.0);
    ray.home = path.home;
    ray.instance = path.instance;
    return ray;
}

void main() {
    uint segment = segment_index(args.segments);
    if (segment == NO_SEGMENT) return;
    uint first = segment * SEGMENT_SIZE;
    uint count = segments[segment].paths;
    uint shadows = 0u;
    for (uint base = 0u; base < count; base += WORKGROUP_SIZE) {
        uint i = base + gl_LocalInvocationID.x;
        PathState path = path_load(first + min(i, count - 1u));
        bool hit = i < count && path.triangle != NO_TRIANGLE;
        ShadowRay ray;
        if (hit) ray = occlusion_ray(path);
        Scan rays = scan_keepers(hit);
        shadow_ray_store(first + shadows + scan_place(rays, hit), ray);
        shadows += rays.total;
    }
    if (gl_LocalInvocationID.x == 0u) {
        segments[segment].paths = 0u;
        segments[segment].shadows = shadows;
    }
}
