// Adds the pass's path radiances to the film; see accumulate.glsl.h.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "accumulate.glsl.h"
#include "../core/film.glsl"
#include "../core/paths.glsl"
#include "../core/segment.glsl"

layout(set = 0, binding = BIND_FILM, scalar) buffer FilmBlock { FilmPixel film[]; };
layout(push_constant, scalar) uniform ArgsBlock { AccumulateArgs args; };

const uint MAX_SAMPLES_PER_PASS = 1024u;

void report_invalid(uint home) {
    PathOwner owner = segment_owner(args.segments, home);
    if (atomicAdd(frame.diagnostics.at[0].invalid_count, 1u) == 0u) {
        frame.diagnostics.at[0].invalid_pixel = owner.pixel.x | owner.pixel.y << 16;
        frame.diagnostics.at[0].invalid_sample = owner.sample_index;
    }
}

void main() {
    uint spp = 1u << args.segments.samples_log2;
    uint ordinal = (args.segments.first_segment * SEGMENT_SIZE >> args.segments.samples_log2) + workgroup_index() * WORKGROUP_SIZE +
                   gl_LocalInvocationID.x;
    uint end = min(args.segments.path_count, (args.segments.first_segment + args.segments.segment_count) * SEGMENT_SIZE);
    if (ordinal * spp >= end) return;
    uint at = args.segments.first_ordinal - args.segments.chunk_ordinal + ordinal;
    FilmPixel pixel = film[at];
    uint saturated = 0u;
    for (uint s = 0u; s < min(spp, MAX_SAMPLES_PER_PASS); ++s) {
        uint home = ordinal * spp + s;
        vec3 x = radiance[home].rgb;
        // Written so that NaN counts as invalid.
        bool valid = all(greaterThanEqual(x, vec3(0.0))) && all(lessThan(x, vec3(3.0e38)));
        if (!valid) {
            report_invalid(home);
            x = vec3(0.0);
        }
        if (any(greaterThan(x, vec3(FILM_MAX_SAMPLE)))) ++saturated;
        x = min(x, vec3(FILM_MAX_SAMPLE));
        film_add(pixel, 0u, x.r);
        film_add(pixel, 1u, x.g);
        film_add(pixel, 2u, x.b);
    }
    if (saturated != 0u) atomicAdd(frame.diagnostics.at[0].saturated_count, saturated);
    pixel.count += spp;
    film[at] = pixel;
}
