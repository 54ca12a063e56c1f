// What was learned about which lights can be seen from where: for each cell of surface points, and each node
// of the light tree's first levels, the share of shadow rays that arrived. Counted by connect in a pass of
// its own, frozen by host/render/learned_visibility.cpp, read by lights/light_visibility.glsl.
#ifndef AJAR_LIGHT_VISIBILITY_GLSL_H
#define AJAR_LIGHT_VISIBILITY_GLSL_H
#include "dual.glsl.h"
DUAL_BEGIN

const uint VISIBILITY_CELLS = 1u << 14; // cells share a place when their hashes do
const uint VISIBILITY_LEVELS = 4;       // decisions of the tree that are learned about
const uint VISIBILITY_CLUSTERS = 1u << 2u * VISIBILITY_LEVELS; // nodes at the end of those
const uint VISIBILITY_COUNTERS = VISIBILITY_CLUSTERS + 1u; // of a cell; the last one: distant lights

// Index cell * VISIBILITY_COUNTERS + cluster.
struct VisibilityCount {
    uint traced;
    uint arrived;
};
DUAL_SIZE(VisibilityCount, 8);
DUAL_PTR(VisibilityCount);

// BIND_VISIBILITY: a byte for each node of each cell, (byte + 1) / 256 being its visibility. Nodes are
// numbered as in a heap of fours: 1 is the root, 4 k to 4 k + 3 the children of k; 0 stands for the distant
// lights.
const uint VISIBILITY_CELL_BYTES = 2u * VISIBILITY_CLUSTERS;
const uint VISIBILITY_CELL_TEXELS = VISIBILITY_CELL_BYTES / 16u;

DUAL_END
#endif
