// All rays of a segment through the hierarchy. The kernel that includes this says which rays, and what
// becomes of them:
#ifndef AJAR_BVH_TRACE_GLSL
#define AJAR_BVH_TRACE_GLSL
BvhRay bvh_ray_of(uint i);
// What ray i met. May be called before the ray is done, with what was found so far, so that no thread has to
// sit out: only the call where `done` is true counts.
void bvh_found(uint i, Hit hit, bool done);

#ifdef AJAR_SUBGROUP
#include "bvh_trace_subgroup.glsl"
#else
#include "bvh_trace_plain.glsl"
#endif

#endif
