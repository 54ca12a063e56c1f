// connect: traces the shadow rays of a segment and adds the contribution of those that arrive to the path's
// radiance. Reads BIND_SHADOW_RAYS, BIND_SEGMENTS; adds to BIND_RADIANCE[home]; counts in SegmentCounts.
// TRACE_SHARES workgroups per segment; a path has at most one shadow ray per bounce, so no two threads add to
// one place.
// SPEC_OPTION chooses the traversal: CONNECT_*; all give the same answers. CONNECT_LEARN adds nothing: it
// counts traced and arrived rays in FrameRecord::visibility_counts.
#ifndef AJAR_CONNECT_GLSL_H
#define AJAR_CONNECT_GLSL_H
#include "../shared/segment_args.glsl.h"
DUAL_BEGIN

const uint CONNECT_TOGETHER = 0; // neighbouring slots hold similar rays: worth tracing together
const uint CONNECT_APART = 1;    // rays of a segment have little in common
const uint CONNECT_LEARN = 2;    // apart, too

struct ConnectArgs {
    SegmentArgs segments;
};
DUAL_SIZE(ConnectArgs, 36);

DUAL_END
#endif
