// shoot: chooses who shoots in a step of progressive refinement (Cohen et al. 1988, "A Progressive Refinement
// Approach to Fast Radiosity Image Generation"): the sides whose unshot power reaches the threshold. Their
// rest becomes what is shot and is 0 from then on; the others shoot nothing. One thread per row.
#ifndef AJAR_SHOOT_GLSL_H
#define AJAR_SHOOT_GLSL_H
#include "../shared/radiosity.glsl.h"
DUAL_BEGIN

struct ShootArgs {
    SideIndexPtr row_sides;   // by row
    SideValuePtr reflectance; // scalar: area, m^2
    SideValuePtr rest;
    SideValuePtr shot;        // out
    SideIndexPtr shooters;    // one word: how many there were is added
    float threshold;          // luminance, W
    uint row_count;
};
DUAL_SIZE(ShootArgs, 48);

DUAL_END
#endif
