// radiate: begins the rays of form factors. Slot = row and ray: from a point of the row's side, uniform over
// it, in a direction by the cosine around the shading normal there, exactly as a path that light sampling
// had no part in would go on from a white Lambertian. F_ij is then the share of rays that meet j first:
//   F_ij = 1 / A_i integral over A_i and A_j of cos cos' V / (pi r^2) = E[ the ray from i meets j ].
// Points and directions are each stratified among a row's rays. A direction below the geometric surface,
// where only bent normals send it, counts as blocked: its pdf is 0.
// Writes BIND_PATHS, SegmentCounts::paths. Followed by extend and tally. One workgroup per segment.
#ifndef AJAR_RADIATE_GLSL_H
#define AJAR_RADIATE_GLSL_H
#include "../shared/element.glsl.h"
#include "../shared/radiosity.glsl.h"
#include "../shared/segment_args.glsl.h"
DUAL_BEGIN

struct RadiateArgs {
    SurfaceElementPtr elements; // by side
    SideIndexPtr row_sides;     // by row
    SegmentArgs segments;       // ordinal: row; sample: ray
    uint pad;
};
DUAL_SIZE(RadiateArgs, 56);

DUAL_END
#endif
