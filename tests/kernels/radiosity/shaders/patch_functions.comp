// Looks points up among patches; see patch_functions.glsl.h.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "patch_functions.glsl.h"
#include "core/workgroup.glsl"
#include "radiosity/patch_lookup.glsl"

layout(push_constant, scalar) uniform ArgsBlock { PatchFunctionsArgs args; };

void main() {
    const uint i = workgroup_index() * WORKGROUP_SIZE + gl_LocalInvocationID.x;
    if (i >= args.count) return;
    const PatchItem item = args.items.at[i];
    const PatchHit hit = patch_lookup(item.index, item.u, item.v);
    args.items.at[i] = PatchItem(hit.index, hit.u, hit.v);
}
