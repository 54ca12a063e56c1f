// shade: what happens where a path met the scene: emission, a shadow ray to a light, the next direction.
// Reads BIND_PATHS after extend; writes the surviving paths back, compacted in order, the shadow rays of the
// bounce to BIND_SHADOW_RAYS, emission to BIND_RADIANCE, and SegmentCounts. One workgroup per segment.
//
// Estimates L = Le + integral of f L |cos| dw at each vertex x of the path, with throughput beta:
//   emission met by BSDF sampling:  beta Le w_b,               w_b = p_b^2 / (p_b^2 + p_l^2)
//   a light picked with pmf:        beta f Le |cos| V / p_l w_l, w_l = p_l^2 / (p_b^2 + p_l^2), p_l = pmf pdf
// p_b and p_l by solid angle: the power heuristic of Veach and Guibas 1995. SPEC_STRATEGY leaves one of the
// two out (its weight is then 1). Delta lobes (p_b = 0 by convention) see lights by BSDF sampling alone,
// delta lights by light sampling alone. At bounce max_bounces + 1 only emission is counted: what the last
// BSDF sample met. SPEC_HEURISTIC: exponent 2 as above, or 1, the balance heuristic.
// SPEC_OPTION: SHADE_WHOLE does all of this. For a shadow ray to every light instead of a picked one, a
// dispatch of SHADE_LIGHT for each makes its shadow rays and leaves paths and emission alone; SHADE_SCATTER
// does the rest. SHADE_LEARN leaves emission alone, and notes with each shadow ray where connect is to count
// it.
// With SHADE_WHITE, for paths that begin on surfaces (place.glsl.h), the surface is a white Lambertian whose
// own emission does not count: beta is then irradiance / pi.
// A segment's paths are sorted first by what they met (hit_lists.glsl): emission is looked at for those that
// met any, everything else is done for those that go on.
#ifndef AJAR_SHADE_GLSL_H
#define AJAR_SHADE_GLSL_H
#include "../shared/segment_args.glsl.h"
DUAL_BEGIN

const uint SHADE_WHOLE = 0;
const uint SHADE_LIGHT = 1;
const uint SHADE_SCATTER = 2;
const uint SHADE_LEARN = 3;
const uint SHADE_WHITE = 4; // added to one of those

struct ShadeArgs {
    SegmentArgs segments;
    uint light; // SHADE_LIGHT: index of the LightRecord
};
DUAL_SIZE(ShadeArgs, 40);

DUAL_END
#endif
