// aov: adds the attributes of the camera rays' hits to the film of first hits. Runs between the first extend
// and shade, when path and slot still coincide. One thread owns a pixel. Reads BIND_PATHS; writes
// FrameRecord::aovs.
#ifndef AJAR_AOV_GLSL_H
#define AJAR_AOV_GLSL_H
#include "../shared/segment_args.glsl.h"
DUAL_BEGIN

struct AovArgs {
    SegmentArgs segments;
};
DUAL_SIZE(AovArgs, 36);

DUAL_END
#endif
