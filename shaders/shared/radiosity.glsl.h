// The linear system of radiosity, x = b + rho F x: a value for each side of a patch, a row of F for each side
// that takes part.
#ifndef AJAR_RADIOSITY_GLSL_H
#define AJAR_RADIOSITY_GLSL_H
#include "bindings.glsl.h"
DUAL_BEGIN

// The vector that a product of rows is taken of, as a texel buffer. It stands in the place of paths'
// radiances, which radiosity's kernels leave alone.
const uint BIND_SIDE_VALUES = BIND_RADIANCE_READ;

// A vector of the system has one for each side (patch.glsl.h) and two more, which are no unknowns: whatever
// row entries name has a place in it.
struct SideValue {
    vec3 rgb;
    float scalar; // what it means depends on the vector
};
DUAL_SIZE(SideValue, 16);
DUAL_PTR(SideValue);

const uint SIDE_NOWHERE = 0; // side count + this: a ray that met nothing that counts
const uint SIDE_SKY = 1;     // side count + this: a ray that left the scene
const uint SIDES_BESIDE = 2;

struct SideIndex {
    uint side;
};
DUAL_SIZE(SideIndex, 4);
DUAL_PTR(SideIndex);

// A row of F: the sides that the row's rays met, in the order of rays, each of weight 1 / rays.
const uint ROW_ENTRIES_PER_WORD = 4;
struct RowWord {
    uint sides[ROW_ENTRIES_PER_WORD];
};
DUAL_SIZE(RowWord, 16);
DUAL_PTR(RowWord);

struct RowTotals {
    uint rays_nowhere[2]; // 64-bit, low word first
    uint rays_sky[2];
};
DUAL_SIZE(RowTotals, 16);
DUAL_PTR(RowTotals);

// Of MEASURE_ROWS consecutive rows: how large the solution x is, and what the solver still owes (`rest`).
const uint MEASURE_ROWS = 64;
struct RowsMeasure {
    float max_rest;  // greatest channel, W/(m^2 sr)
    float max_value;
    float rest_power; // luminance, W: radiosity times area, summed
    float power;
    float max_rest_power; // of one side
    uint pad[3];
};
DUAL_SIZE(RowsMeasure, 32);
DUAL_PTR(RowsMeasure);

DUAL_END
#endif
