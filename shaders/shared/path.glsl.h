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
    vec3 origin;      // world, metres; exactly on the triangle it leaves (no epsilon)
    uint home;        // slot the path was born in: index of its radiance, gives pixel and sample
    vec3 direction;   // world, unit
    // Density of `direction` by solid angle (1/sr) as BSDF sampling made it; 0: delta or camera ray
    float pdf;
    vec3 beta;        // throughput: product of f cos / pdf, Russian roulette included
    uint salt;        // random bits of this ray, for stochastic alpha
    uint triangle;    // in: triangle the ray leaves (NO_TRIANGLE: none); out: triangle hit, in leaf order
    uint instance;    // likewise; index of the InstanceRecord
    float u;          // out: barycentric weight of the triangle's second vertex
    float v;          // out: of its third
};
DUAL_SIZE(PathState, 64);

// A visibility test with what it brings when nothing is in the way.
struct ShadowRay {
    vec3 origin;       // world, metres
    uint home;         // the path's
    vec3 direction;    // world, unit
    float distance;    // metres to the light; hits at or beyond it do not count
    vec3 contribution; // radiance added to the path's when unoccluded
    uint triangle;     // triangle the ray leaves: never hit
    uint instance;
    uint light_triangle; // triangle the ray aims at: never hit; NO_TRIANGLE for other lights
    uint light_instance;
    uint salt;         // random bits of this ray for stochastic alpha
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
