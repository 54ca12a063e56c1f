// update: what a product of rows does to the solution. SPEC_OPTION:
//   UPDATE_GATHER  x = b + rho F x of what the product was taken from; rest = x - x before
//   UPDATE_SHOOT   x += rho F s, rest += rho F s, s being what was shot
// Either way rest is what the rest of the world has not heard of yet. One thread per row.
#ifndef AJAR_UPDATE_GLSL_H
#define AJAR_UPDATE_GLSL_H
#include "../shared/radiosity.glsl.h"
DUAL_BEGIN

const uint UPDATE_GATHER = 0;
const uint UPDATE_SHOOT = 1;

// Vectors, by side.
struct UpdateArgs {
    SideIndexPtr row_sides;   // by row
    SideValuePtr received;    // F x or F s
    SideValuePtr source;      // b
    SideValuePtr reflectance; // rho
    SideValuePtr solution;    // x
    SideValuePtr rest;
    uint first_row;
    uint row_count;
};
DUAL_SIZE(UpdateArgs, 56);

DUAL_END
#endif
