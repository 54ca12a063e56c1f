// tally: which side of which patch each ray of a row met. Runs after radiate and extend: reads BIND_PATHS,
// writes the rows' entries, marks the sides met, and counts rays that met none. One workgroup per segment.
#ifndef AJAR_TALLY_GLSL_H
#define AJAR_TALLY_GLSL_H
#include "../shared/radiosity.glsl.h"
#include "../shared/segment_args.glsl.h"
DUAL_BEGIN

struct TallyArgs {
    SideIndexPtr entries; // ray k of row r: at (r - first_row) << rays_log2 | k
    SideIndexPtr met;     // by side: 1 where one of its entries is not 0
    RowTotalsPtr totals;
    SegmentArgs segments;
    uint first_row; // of `entries`
    uint rays_log2; // rays of a row
    uint side_count;
};
DUAL_SIZE(TallyArgs, 72);

DUAL_END
#endif
