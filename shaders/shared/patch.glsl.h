// BIND_PATCHES: how scene triangles are divided into patches, and what radiosity found for them: the root
// of each triangle's tree (a word each, in leaf order), the trees' nodes, the patches' sides. Divided by
// host/radiosity/patch_mesh, uploaded by host/render/patch_table, read by radiosity/*.glsl.
#ifndef AJAR_PATCH_GLSL_H
#define AJAR_PATCH_GLSL_H
#include "dual.glsl.h"
DUAL_BEGIN

// A triangle of a tree of bisections whose leaves are the patches. Of the split edge's ends p (vertex `edge`)
// and q (the next vertex) and their middle m, the first child has m in the place of q, the second m in the
// place of p; the other vertices keep their places, so that the orientation is kept too. A point of
// barycentrics b lies in the first child where b_p >= b_q, with b_p - b_q in the place of b_p and 2 b_q in
// that of b_q; in the second with p and q exchanged.
struct PatchNode {
    uint child; // index of the first child, the second follows it; a leaf's: index of its patch | PATCH_LEAF
    uint edge;  // 0, 1, 2: which is split; a leaf's: 0
    uint pad[2];
};
DUAL_SIZE(PatchNode, 16);

const uint PATCH_LEAF = 1u << 31;
const uint PATCH_NONE = 0xffffffffu; // in the place of a root: the triangle has no area, hence no patches
const uint PATCH_MAX_DEPTH = 64;     // inner nodes above a leaf
const uint MAX_PATCHES = 1u << 24;

// A patch has two sides, whose numbers index all that is solved for.
const uint PATCH_FRONT = 0; // side = 2 * patch + PATCH_FRONT
const uint PATCH_BACK = 1;

// What pictures are made of: three texels.
struct PatchSide {
    vec3 radiance;      // W/(m^2 sr): constant over the patch; what it reflects and what it emits
    vec3 irradiance[3]; // W/m^2: of all light that arrives, at its corners; linear between them
};
DUAL_SIZE(PatchSide, 48);

const uint PATCH_SIDE_TEXELS = 3;

DUAL_END
#endif
