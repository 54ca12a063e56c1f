// place: begins the paths of one pass on surface elements instead of at the camera: ordinal = element. Every
// slot looks as if a ray perpendicular to the element had just met it, so that shade at bounce 0 follows
// without an extend. Points are uniform over the element (DIM_PIXEL).
// Writes BIND_PATHS, BIND_RADIANCE, SegmentCounts::paths and shadows. One workgroup per segment.
#ifndef AJAR_PLACE_GLSL_H
#define AJAR_PLACE_GLSL_H
#include "../shared/element.glsl.h"
#include "../shared/segment_args.glsl.h"
DUAL_BEGIN

struct PlaceArgs {
    SurfaceElementPtr elements; // by ordinal
    SegmentArgs segments;
    uint pad;
};
DUAL_SIZE(PlaceArgs, 48);

DUAL_END
#endif
