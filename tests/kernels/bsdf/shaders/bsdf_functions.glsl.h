// bsdf_functions: applies one function of shaders/bsdf to each of `count` items, for tests. SPEC_OPTION:
// BSDF_*. Reads items_in, writes items_out; what their words mean is said at each BSDF_*. All directions
// local.
#ifndef AJAR_BSDF_FUNCTIONS_GLSL_H
#define AJAR_BSDF_FUNCTIONS_GLSL_H
#include "../../../../shaders/shared/frame.glsl.h"
DUAL_BEGIN

const uint BSDF_SAMPLE = 0; // in: u, u_lobe. Out: wi, pdf; weight, delta (0 or 1)
const uint BSDF_EVAL = 1;   // in: wo; wi. Out: f, pdf
// In: a cell s0, s1, t0, t1 of [0, 1]^2, in which s stands for a polar angle and t 2 pi for an azimuth. Out:
// integrals
// of f cos (red) and of the pdf over the cell's directions wi.
const uint BSDF_INTEGRATE_DIRECTION = 2; // of wi: theta = s pi / 2
const uint BSDF_INTEGRATE_HALF = 3; // of the half vector: theta = alpha ((1 + pi / (2 alpha))^s - 1)
const uint BSDF_SHADING_NORMAL = 4; // in: n; wo. Out: the adapted n, where ng is +z
const uint BSDF_ALBEDO = 5;         // out: albedo
// Points of a cell: a Fibonacci lattice, exact enough for smooth functions and for edges across the cell.
const uint BSDF_INTEGRATE_POINTS = 1597;
const uint BSDF_INTEGRATE_GENERATOR = 987;

struct BsdfFunctionsArgs {
    TableWordPtr items_in;
    TableWordPtr items_out;
    vec3 base_color;
    float metallic;
    vec3 f0;    // of the dielectric
    float f90;
    vec3 wo;
    float alpha;
    uint count;
    uint pad;
};
DUAL_SIZE(BsdfFunctionsArgs, 72);

DUAL_END
#endif
