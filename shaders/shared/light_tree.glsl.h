// The light tree in BIND_LIGHTS: a hierarchy over the lights that are somewhere (triangles, points, spots,
// spheres), four children to a node. Built by host/render/light_tree.cpp, descended by
// lights/light_tree.glsl. After Conty Estevez and Kulla 2018, "Importance Sampling of Many Lights with
// Adaptive Tree Splitting"; wide and quantised like the hierarchy for rays.
#ifndef AJAR_LIGHT_TREE_GLSL_H
#define AJAR_LIGHT_TREE_GLSL_H
#include "dual.glsl.h"
DUAL_BEGIN

const uint LIGHT_TREE_TWO_SIDED = 1u << 30; // of a place, and of the root's flags: emits to both sides
const uint LIGHT_TREE_MAX_DEPTH = 15; // decisions from root to leaf: two bits of a trail each

// Scales of what is quantised.
const uint LIGHT_TREE_PLACE_STEPS = 1023; // of a centre, across the parent's sphere along an axis
// Of the square root of a radius over the parent's; up to 255, as a child's sphere may be the larger one by
// its rounding
const uint LIGHT_TREE_RADIUS_STEPS = 250;
const uint LIGHT_TREE_SNORM = 127;        // of axes and cosines
const uint LIGHT_TREE_EXPONENT = 96;      // of intensities: see LightTreeNode::axis

// Everything. It takes the room of a node, so that nodes do not straddle cache lines.
struct LightTreeRoot {
    vec3 center;     // of a sphere around all lights, world, metres
    float radius;
    uint axis;       // of a cone around all their normals: 3 x snorm8, not quite a unit vector
    uint cones;      // snorm8: cosine of that cone's half angle | of how far light leaves it << 8
    float intensity; // greatest that they send into one direction, luminance, W/sr
    uint flags;      // LIGHT_TREE_TWO_SIDED or 0; what is below it is node 0's
};
DUAL_SIZE(LightTreeRoot, 32);

// Up to four children, nodes before lights; one that is not there has intensity 0. Spheres are relative to
// this node's own as its parent decodes it (the root's for node 0), cosines are rounded down, radii up.
struct LightTreeNode {
    uint place[4];   // centre: 3 x 10 bits from the low corner of the parent's box; LIGHT_TREE_TWO_SIDED
    // 3 x snorm8 as in the root; in the high byte the intensity in proportion to its siblings: 3 bits of
    // mantissa below 5 of exponent, 2^(e - 31) (1 + m / 8); 0: nothing is there
    uint axis[4];
    uint radii;      // a byte each, child k in byte k: root of the radius over the parent's
    uint normals;    // snorm8 each: cosine of the half angle of the cone of normals
    uint emission;   // snorm8 each: cosine of how far light leaves that cone
    // How many children are nodes << LIGHT_TREE_COUNT_SHIFT | the first of those; the others follow it
    uint nodes;
    uint lights[4];  // of the other children; needed only at the end of a way
};
DUAL_SIZE(LightTreeNode, 64);

const uint LIGHT_TREE_COUNT_SHIFT = 28;
const uint LIGHT_TREE_FIRST = (1u << LIGHT_TREE_COUNT_SHIFT) - 1u;
const uint LIGHT_TREE_NODE_TEXELS = 4;

// Follows the nodes: a word per light, whose bits from LIGHT_TREE_TRAIL_TOP down are the decisions on the way
// to it, two each: which child. After the last one they are 0.
const uint LIGHT_TREE_TRAIL_TOP = 30;
const uint NO_TRAIL = 0xffffffffu; // not in the tree: distant, or without power

DUAL_END
#endif
