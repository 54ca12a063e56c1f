// generate: begins the paths of one pass: a camera ray in every slot, its radiance zeroed.
// Writes BIND_PATHS, BIND_RADIANCE, SegmentCounts::paths and shadows. One workgroup per segment.
// SPEC_OPTION: FILTER_*. The pixel filter is sampled, so every sample has weight 1: pixel = E[ L(camera ray
// through filter sample) ].
#ifndef AJAR_GENERATE_GLSL_H
#define AJAR_GENERATE_GLSL_H
#include "../shared/segment_args.glsl.h"
DUAL_BEGIN

struct GenerateArgs {
    SegmentArgs segments;
};
DUAL_SIZE(GenerateArgs, 36);

DUAL_END
#endif
