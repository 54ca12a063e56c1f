// The arguments of every kernel that walks segments.
#ifndef AJAR_SEGMENT_ARGS_GLSL_H
#define AJAR_SEGMENT_ARGS_GLSL_H
#include "dual.glsl.h"
DUAL_BEGIN

// Slot s of the pass is sample first_sample + s % n of ordinal first_ordinal + s / n, n = 2^samples_log2:
// shifts, since
// lavapipe divides integers lane by lane.
// Workgroup w takes segment first_segment + (w * segment_stride) % segment_count: interleaved, so that every
// contiguous share of workgroups (a driver's thread may get one) is a fair sample of the picture.
struct SegmentArgs {
    uint segment_count;     // of this dispatch
    uint first_segment;
    uint segment_stride;    // coprime to segment_count
    uint bounce;            // 0: camera rays
    uint path_count;        // slots in use in the whole pass; the last segment may be partly filled
    uint first_ordinal;     // of the pass's first pixel, in the whole image
    uint chunk_ordinal;     // of the first pixel in the bound film chunk
    uint samples_log2;      // samples per pixel in this pass: 2^samples_log2
    uint first_sample;
};
DUAL_SIZE(SegmentArgs, 36);

DUAL_END
#endif
