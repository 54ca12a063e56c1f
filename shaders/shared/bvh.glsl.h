// BIND_NODES and BIND_TRIANGLES: the hierarchy that rays walk. Built by host/bvh, read by geometry/bvh.glsl.
// Wide nodes with quantised boxes after Ylitie, Karras and Laine 2017, "Efficient Incoherent Ray Traversal on
// GPUs Through Compressed Wide BVHs".
#ifndef AJAR_BVH_GLSL_H
#define AJAR_BVH_GLSL_H
#include "dual.glsl.h"
DUAL_BEGIN

const uint BVH_WIDTH = 8;
const uint BVH_MAX_DEPTH = 32;     // nodes on a way from root to leaf; both levels together: twice that
const uint BVH_REGISTERS = 12;     // at most so many groups of a ray's stack are kept in registers
const uint BVH_MAX_LEAF = 3;       // triangles of a leaf
const uint BVH_NODE_TEXELS = 5;
const uint BVH_MAX_NODES = 1u << 24;

// Eight slots, each empty, an inner child or a leaf of up to three triangles (in the hierarchy over
// instances: one instance). A slot's box is origin + q * 2^(exponent - 127) per axis, conservative by a
// margin that covers the rounding of the slab test. Slots are filled so that slot ^ octant of a ray's
// direction goes roughly front to back.
struct BvhNode {
    vec3 origin;          // lower corner of the node, in the frame of its triangles, metres
    uint exponents;       // biased exponent of a step along x | y << 8 | z << 16
    uint child_base;      // node index of slot 0, times 256; children lie at their slots, with gaps
    uint inner_orders;    // byte k = 0 to 3: bit s ^ k is set where slot s has an inner child
    uint triangle_base;   // index of the first triangle (or instance) of the node's leaves
    uint leaves;          // bit 3 s + k: slot s is a leaf of more than k triangles; in the triangles' order
    uint lower_x[2];      // byte s: slot s
    uint lower_y[2];
    uint lower_z[2];
    uint upper_x[2];
    uint upper_y[2];
    uint upper_z[2];
};
DUAL_SIZE(BvhNode, 80);

// A triangle in leaf order. Coordinate by coordinate, so that a ray that permutes the axes permutes
// addresses.
struct TriangleRecord {
    vec3 x;        // of the three vertices; metres, in the frame of its mesh (instance 0: the world)
    uint flags;    // TRIANGLE_*
    vec3 y;
    uint material; // index of the MaterialRecord
    vec3 z;
    uint object;   // instance 0: Scene::instances index, for AOVs
};
DUAL_SIZE(TriangleRecord, 48);

const uint TRIANGLE_TEXELS = 3;
const float TRIANGLE_T_ERROR = 4.7683716e-7f; // 2^-21: eight roundings of t, in units of the triangle's reach
const uint TRIANGLE_ALPHA = 1u << 0; // a hit counts only where alpha_passes() says so
const uint TRIANGLE_EMITS = 1u << 1; // whoever looks at it may see light of its own
const uint TRIANGLE_SCATTERS = 1u << 2; // light that falls on it may go on

DUAL_END
#endif
