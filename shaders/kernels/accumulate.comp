// Adds the pass's path radiances to the film; see accumulate.glsl.h.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "accumulate.glsl.h"
#include "../core/film.glsl"
#include "../core/math.glsl"
#include "../core/paths.glsl"
#include "../core/segment.glsl"

layout(set = 0, binding = BIND_FILM, std430) buffer FilmBlock { uvec4 film_words[]; };
FilmPixel film_load(uint at) {
    uvec4 a = film_words[4u * at];
    uvec4 b = film_words[4u * at + 1u];
    uvec4 c = film_words[4u * at + 2u];
    uvec4 d = film_words[4u * at + 3u];
    return FilmPixel(a.x, uint[6](a.y, a.z, a.w, b.x, b.y, b.z), uint[9](b.w, c.x, c.y, c.z, c.w, d.x, d.y,
        d.z, d.w));
}

void film_store(uint at, FilmPixel p) {
    film_words[4u * at] = uvec4(p.count, p.sum[0], p.sum[1], p.sum[2]);
    film_words[4u * at + 1u] = uvec4(p.sum[3], p.sum[4], p.sum[5], p.square[0]);
    film_words[4u * at + 2u] = uvec4(p.square[1], p.square[2], p.square[3], p.square[4]);
    film_words[4u * at + 3u] = uvec4(p.square[5], p.square[6], p.square[7], p.square[8]);
}

layout(push_constant, scalar) uniform ArgsBlock { AccumulateArgs args; };

const uint MAX_SAMPLES_PER_PASS = 1024u;

void report_invalid(uint home) {
    PathOwner owner = segment_owner(args.segments, home);
    if (atomicAdd(frame.diagnostics.at[0].invalid_count, 1u) == 0u) {
        frame.diagnostics.at[0].invalid_pixel = frame.pixel_order.at[owner.ordinal].packed;
        frame.diagnostics.at[0].invalid_sample = owner.sample_index;
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
    uint at = args.segments.first_ordinal - args.segments.chunk_ordinal + ordinal;
    FilmPixel pixel = film_load(at);
    uint saturated = 0u;
    for (uint s = 0u; s < min(spp, MAX_SAMPLES_PER_PASS); ++s) {
        uint home = ordinal * spp + s;
        vec3 x = radiance_load(home);
        // Written so that NaN counts as invalid.
        bool valid = all(greaterThanEqual(x, vec3(0.0))) && all(lessThan(x, vec3(3.0e38)));
        if (!valid) {
            report_invalid(home);
            x = vec3(0.0);
        }
        // A clamped sample keeps its hue.
        float peak = math_max3(x);
        x *= peak > frame.sample_clamp ? frame.sample_clamp / peak : 1.0;
        if (any(greaterThan(x, vec3(FILM_MAX_SAMPLE)))) ++saturated;
        x = min(x, vec3(FILM_MAX_SAMPLE));
        film_add(pixel, 0u, x.r);
        film_add(pixel, 1u, x.g);
        film_add(pixel, 2u, x.b);
    }
    if (saturated != 0u) atomicAdd(frame.diagnostics.at[0].saturated_count, saturated);
    pixel.count += spp;
    film_store(at, pixel);
}
