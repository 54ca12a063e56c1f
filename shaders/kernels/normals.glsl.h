// normals: shows the shading normal the camera sees, -1..1 per axis as 0..1 (normal maps included).
// A newcomer's example: everything an integrator of camera rays needs. Runs after one extend; reads
// BIND_PATHS, writes BIND_RADIANCE. One workgroup per segment.
#ifndef AJAR_NORMALS_GLSL_H
#define AJAR_NORMALS_GLSL_H
#include "../shared/segment_args.glsl.h"
DUAL_BEGIN

struct NormalsArgs {
    SegmentArgs segments;
};
DUAL_SIZE(NormalsArgs, 36);

DUAL_END
#endif
