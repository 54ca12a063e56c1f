// measure: how large the solution is and what is owed to it, over MEASURE_ROWS rows a thread, in their order;
// the host adds up what the threads found.
#ifndef AJAR_MEASURE_GLSL_H
#define AJAR_MEASURE_GLSL_H
#include "../shared/radiosity.glsl.h"
DUAL_BEGIN

struct MeasureArgs {
    SideIndexPtr row_sides;   // by row
    SideValuePtr reflectance; // scalar: area, m^2
    SideValuePtr solution;
    SideValuePtr rest;
    RowsMeasurePtr measures;  // out: by thread
    uint row_count;
    uint pad;
};
DUAL_SIZE(MeasureArgs, 48);

DUAL_END
#endif
