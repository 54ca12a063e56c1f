// Begins paths on surfaces; see place.glsl.h.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "place.glsl.h"
#include "../core/paths.glsl"
#include "../core/sampler.glsl"
#include "../core/segment.glsl"
#include "../geometry/element.glsl"
#include "../shared/dimensions.glsl.h"

layout(push_constant, scalar) uniform ArgsBlock { PlaceArgs args; };

void main() {
    uint segment = segment_index(args.segments);
    if (segment == NO_SEGMENT) return;
    uint first = segment * SEGMENT_SIZE;
    uint count = segment_fill(args.segments, segment);
    for (uint i = gl_LocalInvocationID.x; i < count; i += WORKGROUP_SIZE) {
        uint home = first + i;
        SurfaceElement element = args.elements.at[segment_owner(args.segments, home).ordinal];
        vec2 at = element_point(element, sampler_2d(segment_sampler(args.segments, home), DIM_PIXEL));
        PathState path;
        path.origin = vec3(0.0); // nobody asks where the ray came from
        path.direction = -element_normal(element);
        path.home = home;
        path.pdf = 0.0;
        path.beta = vec3(1.0);
        path.leaves = NO_TRIANGLE;
        path.instance = 0u;
        path_store(home, path);
        path_store_hit(home, element.triangle, 0u, at.x, at.y);
        radiance_store(home, vec3(0.0));
    }
    if (gl_LocalInvocationID.x == 0u) {
        segments[segment].paths = count;
        segments[segment].shadows = 0u;
    }
}
