// Shows reflectance; see albedo.glsl.h.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "albedo.glsl.h"
#include "../core/paths.glsl"
#include "../core/segment.glsl"
#include "../material/vertex.glsl"

layout(push_constant, scalar) uniform ArgsBlock { AlbedoArgs args; };

void main() {
    uint segment = segment_index(args.segments);
    if (segment == NO_SEGMENT) return;
    uint first = segment * SEGMENT_SIZE;
    uint count = segments[segment].paths;
    for (uint i = gl_LocalInvocationID.x; i < count; i += WORKGROUP_SIZE) {
        PathState path = path_load(first + i);
        if (path.triangle != NO_TRIANGLE) {
            Vertex v = vertex_at(path);
            radiance_store(path.home, bsdf_albedo(v.bsdf));
        }
    }
}
