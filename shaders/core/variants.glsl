// Specialization constants as kernels see them; the host sets them by the SPEC_* ids.
#ifndef AJAR_VARIANTS_GLSL
#define AJAR_VARIANTS_GLSL
#include "../shared/specialization.glsl.h"

layout(local_size_x_id = 0) in; // SPEC_WORKGROUP_SIZE
#define WORKGROUP_SIZE gl_WorkGroupSize.x
layout(constant_id = 1) const uint SEGMENT_SIZE = 256;
layout(constant_id = 2) const uint TEXEL_BUFFERS = 1;
layout(constant_id = 3) const uint FEATURES = 0;
layout(constant_id = 4) const uint STRATEGY = 2;
layout(constant_id = 5) const uint LIGHT_SAMPLER = 0;
layout(constant_id = 6) const uint OPTION = 0;
layout(constant_id = 7) const uint PATH_TEXELS = 0;
layout(constant_id = 8) const uint STACK_REGISTERS = 0;
layout(constant_id = 10) const uint HEURISTIC = 0;
layout(constant_id = 11) const uint TRACE_SHARES = 1;
layout(constant_id = 9) const uint SAMPLER = 0;

bool has_feature(uint bits) { return (FEATURES & bits) != 0u; }

#endif
