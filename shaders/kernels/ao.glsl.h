// ao: ambient occlusion. The share of cosine-weighted directions at the camera's hit in which nothing stands
// nearer than FrameRecord::ao_distance: E[ V(x, w) ], w by the cosine around the shading normal (cosine and
// pi cancel). Runs after one extend and before connect: reads BIND_PATHS, writes BIND_SHADOW_RAYS. One
// workgroup per segment.
#ifndef AJAR_AO_GLSL_H
#define AJAR_AO_GLSL_H
#include "../shared/segment_args.glsl.h"
DUAL_BEGIN

struct AoArgs {
    SegmentArgs segments;
};
DUAL_SIZE(AoArgs, 36);

DUAL_END
#endif
