// Shows shading normals; see normals.glsl.h.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "normals.glsl.h"
#include "../core/paths.glsl"
#include "../core/segment.glsl"
#include "../material/vertex.glsl"

layout(push_constant, scalar) uniform ArgsBlock { NormalsArgs args; };

void main() {
    uint segment = segment_index(args.segments);
    if (segment == NO_SEGMENT) return;
    uint first = segment * SEGMENT_SIZE;
    uint count = segments[segment].paths;
    for (uint i = gl_LocalInvocationID.x; i < count; i += WORKGROUP_SIZE) {
        PathState path = path_load(first + i);
        if (path.triangle != NO_TRIANGLE) {
            Vertex v = vertex_at(path);
            radiance_store(path.home, 0.5 * v.frame.n + 0.5);
        }
    }
}
