// Attributes of the camera rays' hits; see aov.glsl.h.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "aov.glsl.h"
#include "../core/film.glsl"
#include "../core/paths.glsl"
#include "../core/segment.glsl"
#include "../material/vertex.glsl"

layout(push_constant, scalar) uniform ArgsBlock { AovArgs args; };

const uint MAX_SAMPLES_PER_PASS = 1024u;

void add3(inout AovPixel pixel, uint channel, vec3 x) {
    for (uint c = 0u; c < 3u; ++c) {
        uint word = 2u * (channel + c);
        uvec2 sum = film_add64(uvec2(pixel.sum[word], pixel.sum[word + 1u]), film_fixed_signed(x[c]));
        pixel.sum[word] = sum.x;
        pixel.sum[word + 1u] = sum.y;
    }
}

void add_hit(inout AovPixel pixel, PathState path, bool first_of_pixel) {
    Vertex v = vertex_at(path);
    add3(pixel, 0u, bsdf_albedo(v.bsdf));
    add3(pixel, 3u, v.frame.n);
    add3(pixel, 6u, v.surface.position);
    // Along the camera's axis, as compositors expect.
    float depth = dot(frame.camera_origin - v.surface.position, frame.camera_back);
    uvec2 sum = film_add64(uvec2(pixel.sum[18], pixel.sum[19]), film_fixed_signed(depth));
    pixel.sum[18] = sum.x;
    pixel.sum[19] = sum.y;
    add3(pixel, 10u, vertex_emission(v));
    pixel.hits += 1u;
    if (first_of_pixel) {
        pixel.object_id = v.surface.object + 1u;
        pixel.material_id = v.surface.material + 1u;
    }
}

void main() {
    uint spp = 1u << args.segments.samples_log2;
    uint ordinal = (args.segments.first_segment * SEGMENT_SIZE >> args.segments.samples_log2) +
        workgroup_index() * WORKGROUP_SIZE +
                   gl_LocalInvocationID.x;
    uint end = min(args.segments.path_count, (args.segments.first_segment +
        args.segments.segment_count) * SEGMENT_SIZE);
    if (ordinal * spp >= end) return;
    uint at = args.segments.first_ordinal + ordinal;
    AovPixel pixel = frame.aovs.at[at];
    for (uint s = 0u; s < min(spp, MAX_SAMPLES_PER_PASS); ++s) {
        PathState path = path_load(ordinal * spp + s);
        if (path.triangle != NO_TRIANGLE) add_hit(pixel, path, args.segments.first_sample + s == 0u);
    }
    frame.aovs.at[at] = pixel;
}
