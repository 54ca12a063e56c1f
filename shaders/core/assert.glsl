// ASSERT(condition): what the author of a kernel believes. Free unless AJAR_DEBUG; then failures are counted
// in frame.diagnostics, with line and thread of one of them, for the host to throw.
#ifndef AJAR_ASSERT_GLSL
#define AJAR_ASSERT_GLSL
#include "tables.glsl"
#include "workgroup.glsl"

#ifdef AJAR_DEBUG
#extension GL_EXT_buffer_reference_uvec2 : require

void assert_failed(uint line) {
    if (all(equal(uvec2(frame.diagnostics), uvec2(0)))) return; // nobody listens
    if (atomicAdd(frame.diagnostics.at[0].assert_count, 1u) == 0u) {
        frame.diagnostics.at[0].assert_line = line;
        frame.diagnostics.at[0].assert_thread = workgroup_index() * WORKGROUP_SIZE + gl_LocalInvocationID.x;
    }
}
#define ASSERT(condition) { if (!(condition)) assert_failed(uint(__LINE__)); }
#else
#define ASSERT(condition)
#endif

#endif
