// show_patches: ends paths where they met a patch: adds what radiosity found there, and light that is in no
// patch. SPEC_OPTION:
//   SHOW_FLAT    beta L, L the patch's constant radiance
//   SHOW_SMOOTH  beta (Le w + rho / pi E), E linear between the patch's corners, Le and rho of the very point
// After the camera rays' extend this is a picture of the solution; after shade, connect and another extend
// the end of a final gather, E[ f |cos| / pdf L ] over what BSDF samples meet. w is then shade's weight of
// emission that BSDF sampling met; seen by the camera, 1. rho(wo) is one BSDF sample's weight, whose mean
// it is: without noise where surfaces are Lambertian.
// Reads BIND_PATHS, BIND_PATCHES; adds to BIND_RADIANCE. One workgroup per segment.
#ifndef AJAR_SHOW_PATCHES_GLSL_H
#define AJAR_SHOW_PATCHES_GLSL_H
#include "../shared/segment_args.glsl.h"
DUAL_BEGIN

const uint SHOW_FLAT = 0;
const uint SHOW_SMOOTH = 1;

struct ShowPatchesArgs {
    SegmentArgs segments;
};
DUAL_SIZE(ShowPatchesArgs, 36);

DUAL_END
#endif
