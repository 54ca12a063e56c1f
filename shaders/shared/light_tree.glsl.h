// The light tree in BIND_LIGHTS: a binary hierarchy over the lights that are somewhere (triangles, points,
// spots). Built by host/render/light_tree.cpp, descended by lights/light_tree.glsl. After Conty Estevez and
// Kulla 2018, "Importance Sampling of Many Lights with Adaptive Tree Splitting".
#ifndef AJAR_LIGHT_TREE_GLSL_H
#define AJAR_LIGHT_TREE_GLSL_H
#include "dual.glsl.h"
DUAL_BEGIN

const uint LIGHT_TREE_LEAF = 1u << 31;      // of LightTreeNode::child
const uint LIGHT_TREE_TWO_SIDED = 1u << 30; // emits to both sides of its cone's axis
const uint LIGHT_TREE_INDEX = LIGHT_TREE_TWO_SIDED - 1u;
const uint LIGHT_TREE_MAX_DEPTH = 31; // decisions from root to leaf, so that NO_TRAIL is nobody's

// Siblings lie side by side: pair k is nodes 2 k and 2 k + 1, 64 bytes. Node 0 is the root, node 1 nothing.
struct LightTreeNode {
    vec3 center;     // of a sphere around all lights below, world, metres
    float radius;
    uint axis;       // octahedral: of a cone around all their normals
    uint cones;      // snorm16 cosines, rounded down: half angle of that cone | how far light leaves it << 16
    float intensity; // greatest that they send into one direction, luminance, W/sr
    uint child;      // leaf: index of the light; else of the pair below; with LIGHT_TREE_* bits
};
DUAL_SIZE(LightTreeNode, 32);

const uint LIGHT_TREE_PAIR_TEXELS = 4;

// Follows the nodes: a word per light, bit d of which is the way to take at depth d (1: the second of the
// pair).
const uint NO_TRAIL = 0xffffffffu; // not in the tree: distant, or without power

DUAL_END
#endif
