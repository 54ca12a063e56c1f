// naive: the lecture's first path tracer, and the shortest integrator to read. One random direction per
// vertex, no shadow rays: lights are found by chance. A path's radiance is the sum of beta Le over what it
// meets, beta the product of f |cos| / pdf; paths end after max_bounces + 1 hits beyond the first, by
// absorption or by Russian roulette. Reads BIND_PATHS after extend; writes survivors back, compacted,
// emission to BIND_RADIANCE. One workgroup per segment. SPEC_OPTION: NAIVE_BSDF samples the BSDF,
// NAIVE_COSINE the cosine around the shading normal (of a diffuse surface the weight is then just the
// reflectance; mirrors cannot be found this way and stay black).
#ifndef AJAR_NAIVE_GLSL_H
#define AJAR_NAIVE_GLSL_H
#include "../shared/segment_args.glsl.h"
DUAL_BEGIN

const uint NAIVE_BSDF = 0;
const uint NAIVE_COSINE = 1;

struct NaiveArgs {
    SegmentArgs segments;
};
DUAL_SIZE(NaiveArgs, 36);

DUAL_END
#endif
