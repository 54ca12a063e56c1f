// extend: where does each ray meet the scene? For all live paths of a segment.
// Reads PathState origin, direction, leaves and instance, BIND_SEGMENTS;
// writes PathState triangle, instance, u, v and SegmentCounts::rays_traced. TRACE_SHARES workgroups per
// segment.
// SPEC_OPTION chooses the traversal: EXTEND_*; all give the same hits.
#ifndef AJAR_EXTEND_GLSL_H
#define AJAR_EXTEND_GLSL_H
#include "../shared/segment_args.glsl.h"
DUAL_BEGIN

const uint EXTEND_CAMERA = 0; // neighbouring slots hold similar rays: worth tracing together
const uint EXTEND_BOUNCE = 1; // rays of a segment have little in common

struct ExtendArgs {
    SegmentArgs segments;
};
DUAL_SIZE(ExtendArgs, 36);

DUAL_END
#endif
