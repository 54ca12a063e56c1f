// All rays of a segment through the hierarchy. The kernel that includes this says which rays, and what
// becomes of them:
#ifndef AJAR_BVH_TRACE_GLSL
#define AJAR_BVH_TRACE_GLSL
BvhRay bvh_ray_of(uint i);
void bvh_found(uint i, Hit hit);

#ifdef AJAR_SUBGROUP
#include "bvh_trace_subgroup.glsl"
#else
#include "bvh_trace_plain.glsl"
#endif

#endif
