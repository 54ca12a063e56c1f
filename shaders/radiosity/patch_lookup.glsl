// Which patch holds a point of a scene triangle: down the triangle's tree (shared/patch.glsl.h), as
// PatchMesh::find does on the host.
#ifndef AJAR_PATCH_LOOKUP_GLSL
#define AJAR_PATCH_LOOKUP_GLSL
#include "../core/tables.glsl"
#include "../shared/patch.glsl.h"

struct PatchHit {
    uint index; // of the patch; PATCH_NONE: the triangle has none
    float u;    // barycentrics within the patch, of its second vertex
    float v;    // and its third
};

// `triangle` in leaf order, of a scene without instancing; its barycentrics.
PatchHit patch_lookup(uint triangle, float u, float v) {
    const uvec4 roots = fetch_patch(triangle >> 2);
    const uint place = triangle & 3u;
    const uint root = place == 0u ? roots.x : (place == 1u ? roots.y : (place == 2u ? roots.z : roots.w));
    // A triangle without patches stops at once: its bits say leaf.
    uvec2 node = uvec2(PATCH_NONE, 0u);
    if (root != PATCH_NONE) node = fetch_patch(frame.patch_nodes_first + root).xy;
    vec3 b = vec3(1.0 - u - v, u, v);
    for (uint depth = 0u; depth < PATCH_MAX_DEPTH; ++depth) {
        if ((node.x & PATCH_LEAF) != 0u) break;
        // The split edge's ends p and q, and the third vertex.
        const vec3 pqr = node.y == 0u ? b.xyz : (node.y == 1u ? b.yzx : b.zxy);
        const bool second = pqr.x < pqr.y;
        const float kept = abs(pqr.x - pqr.y);
        const float moved = 2.0 * (second ? pqr.x : pqr.y);
        const vec3 child = second ? vec3(moved, kept, pqr.z) : vec3(kept, moved, pqr.z);
        b = node.y == 0u ? child.xyz : (node.y == 1u ? child.zxy : child.yzx);
        node = fetch_patch(frame.patch_nodes_first + node.x + (second ? 1u : 0u)).xy;
    }
    return PatchHit(node.x == PATCH_NONE ? PATCH_NONE : node.x & ~PATCH_LEAF, b.y, b.z);
}

// The side of a patch that a ray of that direction meets; `ng` is the geometric normal towards the front.
uint patch_side(uint patch_index, bool back_face) {
    return 2u * patch_index + (back_face ? PATCH_BACK : PATCH_FRONT);
}

#endif
