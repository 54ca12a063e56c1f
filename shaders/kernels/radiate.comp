// Begins the rays of form factors; see radiate.glsl.h.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "radiate.glsl.h"
#include "../core/paths.glsl"
#include "../core/sampler.glsl"
#include "../core/segment.glsl"
#include "../geometry/element.glsl"
#include "../material/vertex.glsl"

layout(push_constant, scalar) uniform ArgsBlock { RadiateArgs args; };

void main() {
    uint segment = segment_index(args.segments);
    if (segment == NO_SEGMENT) return;
    uint first = segment * SEGMENT_SIZE;
    uint count = segment_fill(args.segments, segment);
    for (uint i = gl_LocalInvocationID.x; i < count; i += WORKGROUP_SIZE) {
        uint home = first + i;
        PathOwner owner = segment_owner(args.segments, home);
        uint side = args.row_sides.at[owner.ordinal].side;
        SurfaceElement element = args.elements.at[side];
        // By side, not by row: a row is the same whatever rows there are.
        Sampler points = sampler_begin(frame.seed, side, owner.sample_index, frame.sequence_log2);
        vec2 at = element_point(element, sampler_2d(points, DIM_PIXEL));
        PathState path;
        path.triangle = element.triangle;
        path.instance = 0u;
        path.u = at.x;
        path.v = at.y;
        path.direction = -element_normal(element);
        Vertex v = vertex_at(path);
        vec3 local = warps_cosine_hemisphere(sampler_2d(points, sampler_bounce(0u) + DIM_BSDF));
        path.direction = frame_to_world(v.frame, local);
        path.pdf = dot(path.direction, v.surface.ng) > 0.0 ? 1.0 : 0.0;
        path.origin = v.surface.departure;
        path.leaves = element.triangle;
        path.home = home;
        path.beta = vec3(1.0);
        path_store(home, path);
    }
    if (gl_LocalInvocationID.x == 0u) segments[segment].paths = count;
}
