// albedo: shows the reflectance of what the camera sees, as if lit from all around (bsdf_albedo).
// A newcomer's example: everything an integrator of camera rays needs. Runs after one extend; reads
// BIND_PATHS, writes BIND_RADIANCE. One workgroup per segment.
#ifndef AJAR_ALBEDO_GLSL_H
#define AJAR_ALBEDO_GLSL_H
#include "../shared/segment_args.glsl.h"
DUAL_BEGIN

struct AlbedoArgs {
    SegmentArgs segments;
};
DUAL_SIZE(AlbedoArgs, 36);

DUAL_END
#endif
