// Path state: what flies between kernels. Segment s owns the slots [s * SEGMENT_SIZE, (s + 1) *
// SEGMENT_SIZE).
#ifndef AJAR_PATH_GLSL_H
#define AJAR_PATH_GLSL_H
#include "dual.glsl.h"
DUAL_BEGIN

const uint NO_TRIANGLE = 0xffffffffu;
const uint MAX_SEGMENT_SIZE = 1024;

// One path under way; compacted within its segment after every bounce.
struct PathState {
    vec3 origin;      // world, metres; off the triangle it leaves by the rounding error (leave.glsl)
    uint home;        // slot the path was born in: index of its radiance, gives pixel and sample
    vec3 direction;   // world, unit
    uint leaves;      // triangle the ray leaves: never hit; NO_TRIANGLE: none
    vec3 beta;        // throughput: product of f cos / pdf, Russian roulette included
    // Density of `direction` by solid angle (1/sr) as BSDF sampling made it; 0: delta or camera ray
    float pdf;
    uint triangle;    // out: triangle hit, in leaf order; NO_TRIANGLE: none
    uint instance;    // index of the InstanceRecord; in: of `leaves`; out: of `triangle`
    float u;          // out: barycentric weight of the triangle's second vertex
    float v;          // out: of its third
};
DUAL_SIZE(PathState, 64);

// A visibility test with what it brings when nothing is in the way.
struct ShadowRay {
    vec3 origin;       // world, metres; as a path's
    uint leaves;       // as a path's
    vec3 direction;    // world, unit
    float reach;       // metres: hits at or beyond it do not count; ends before an emissive triangle's plane
    vec3 contribution; // radiance added to the path's when unoccluded
    uint home;         // the path's
    uint instance;     // of `leaves`
    uint counter;      // where connect counts it while visibility is learned (light_visibility.glsl.h)
    uint pad[2];
};
DUAL_SIZE(ShadowRay, 64);

// A segment's counters, 64 bytes so that no two share a cache line.
struct SegmentCounts {
    uint paths;   // live paths: slots [0, paths) of the segment
    uint shadows; // shadow rays waiting for connect
    uint rays_traced[2];   // extension rays so far, 64-bit, low word first
    uint shadows_traced[2]; // shadow rays so far
    uint shadows_open[2];   // of those, unoccluded
    uint loops_exhausted;  // traversals that ran out of their iteration bound
    uint pad[7];
};
DUAL_SIZE(SegmentCounts, 64);

DUAL_END
#endif
