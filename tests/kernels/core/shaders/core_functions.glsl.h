// core_functions: applies one function of shaders/core to each of `count` items, for tests. SPEC_OPTION:
// CORE_*. Reads in[count], writes out[count], four words each; what they mean is said at each CORE_*.
#ifndef AJAR_CORE_FUNCTIONS_GLSL_H
#define AJAR_CORE_FUNCTIONS_GLSL_H
#include "../../../../shaders/shared/frame.glsl.h"
DUAL_BEGIN

// In: u (2). Out: the point and its density.
const uint CORE_DISK = 0;
const uint CORE_COSINE_HEMISPHERE = 1;
const uint CORE_SPHERE = 2;
const uint CORE_HEMISPHERE = 3;
const uint CORE_CONE = 4; // parameter: 1 - cos
const uint CORE_TRIANGLE = 5;
const uint CORE_FILTER_BOX = 6; // parameter: radius
const uint CORE_FILTER_GAUSSIAN = 7;
const uint CORE_FILTER_BLACKMAN_HARRIS = 8;
// In: seed, pixel, sample, dimension (uint). Out: the pair, the single, all float.
const uint CORE_SAMPLER = 9;
const uint CORE_SOBOL = 10;     // in: index. Out: reversed second dimension (uint)
const uint CORE_SCRAMBLE = 11;  // in: x, seed. Out: scrambled (uint)
// In: x, y. Out: hash(x), combine(x, y), hash_to_float(x), salted_float(x, y, z)
const uint CORE_HASH = 12;
const uint CORE_SRGB = 13;      // in: three values. Out: decoded
const uint CORE_OCTAHEDRAL = 14; // in: code. Out: vector
const uint CORE_FRAME = 15;     // in: n. Out: t and nothing
const uint CORE_FRAME_B = 16;   // in: n. Out: b
const uint CORE_FRAME_TANGENT = 17; // in: n, handedness (w); parameters: tangent. Out: t, handedness as built
const uint CORE_FRAME_ROUND_TRIP = 18; // in: n; parameters: a vector. Out: to_world(to_local(vector))
const uint CORE_ERFINV = 19;    // in: x. Out: erfinv(x)
const uint CORE_FINITE = 20;    // in: three values. Out: 1 where all are finite
const uint CORE_ANGLE = 21;     // in: y, x. Out: angle of (x, y)
const uint CORE_SINE_COSINE = 22; // in: x. Out: sine, cosine

struct CoreFunctionsArgs {
    TableWordPtr items_in;
    TableWordPtr items_out;
    vec4 parameters;
    uint count;
    uint samples_log2; // CORE_SAMPLER: of the blue-noise sequence
};
DUAL_SIZE(CoreFunctionsArgs, 40);

DUAL_END
#endif
