// Begins the paths of one pass; see generate.glsl.h.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "generate.glsl.h"
#include "../core/filter.glsl"
#include "../core/paths.glsl"
#include "../core/sampler.glsl"
#include "../core/segment.glsl"
#include "../shared/dimensions.glsl.h"

layout(push_constant, scalar) uniform ArgsBlock { GenerateArgs args; };

// The ray through a point of the image plane, in pixels from the top left corner.
void camera_ray(vec2 at, out vec3 origin, out vec3 direction) {
    float x = (2.0 * at.x / float(frame.width) - 1.0) * frame.camera_scale_x;
    float y = (1.0 - 2.0 * at.y / float(frame.height)) * frame.camera_scale_y;
    vec3 offset = x * frame.camera_right + y * frame.camera_up;
    bool orthographic = has_feature(FEATURE_ORTHOGRAPHIC);
    origin = orthographic ? frame.camera_origin + offset : frame.camera_origin;
    direction = orthographic ? -frame.camera_back : normalize(offset - frame.camera_back);
}

void main() {
    uint segment = segment_index(args.segments);
    if (segment == NO_SEGMENT) return;
    uint first = segment * SEGMENT_SIZE;
    uint count = segment_fill(args.segments, segment);
    for (uint i = gl_LocalInvocationID.x; i < count; i += WORKGROUP_SIZE) {
        uint home = first + i;
        PathOwner owner = segment_owner(args.segments, home);
        uint pixel = frame.pixel_order.at[owner.ordinal].packed;
        Sampler points = segment_sampler(args.segments, home);
        vec2 offset = filter_sample(OPTION, frame.filter_radius, sampler_2d(points, DIM_PIXEL));
        PathState path;
        camera_ray(vec2(pixel & 0xffffu, pixel >> 16) + 0.5 + offset, path.origin, path.direction);
        path.home = home;
        path.pdf = 0.0;
        path.beta = vec3(1.0);
        path.leaves = NO_TRIANGLE;
        path.instance = 0u;
        path_store(home, path);
        radiance_store(home, vec3(0.0));
    }
    if (gl_LocalInvocationID.x == 0u) {
        segments[segment].paths = count;
        segments[segment].shadows = 0u;
    }
}
