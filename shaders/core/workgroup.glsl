// The index of this workgroup. Where a device allows few workgroups along x, the host spreads them over y, so
// there may be a few more than were asked for: a kernel returns at once where its index is not below the
// count it was given.
#ifndef AJAR_WORKGROUP_GLSL
#define AJAR_WORKGROUP_GLSL

uint workgroup_index() { return gl_WorkGroupID.x + gl_WorkGroupID.y * gl_NumWorkGroups.x; }

#endif
