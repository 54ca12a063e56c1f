// What kernels write: path state, shadow rays, segment counters and path radiances (bindings.glsl.h).
#ifndef AJAR_PATHS_GLSL
#define AJAR_PATHS_GLSL
#include "../shared/bindings.glsl.h"
#include "../shared/path.glsl.h"

layout(set = 0, binding = BIND_PATHS, scalar) buffer PathsBlock { PathState paths[]; };
layout(set = 0, binding = BIND_SHADOW_RAYS, scalar) buffer ShadowRaysBlock { ShadowRay shadow_rays[]; };
layout(set = 0, binding = BIND_SEGMENTS, scalar) buffer SegmentsBlock { SegmentCounts segments[]; };
layout(set = 0, binding = BIND_RADIANCE, scalar) buffer RadianceBlock { vec4 radiance[]; };

#endif
