// accumulate: adds the pass's path radiances to the film. One thread owns a pixel and adds its samples in
// order. Reads BIND_RADIANCE; adds to BIND_FILM; counts what is NaN, Inf, negative (added as black) or too
// bright (cut).
#ifndef AJAR_ACCUMULATE_GLSL_H
#define AJAR_ACCUMULATE_GLSL_H
#include "../shared/segment_args.glsl.h"
DUAL_BEGIN

struct AccumulateArgs {
    SegmentArgs segments; // the pass: path_count, first_ordinal, chunk_ordinal, samples_log2, first_sample
};
DUAL_SIZE(AccumulateArgs, 36);

DUAL_END
#endif
