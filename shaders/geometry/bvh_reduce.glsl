// Reductions over the threads of a workgroup that is one subgroup: every thread gets the result.
#ifndef AJAR_BVH_REDUCE_GLSL
#define AJAR_BVH_REDUCE_GLSL
#include "../core/scan.glsl"

uint bvh_or(uint value) {
    #define BVH_REDUCE(step) value |= subgroupShuffleXor(value, step)
    SCAN_STEPS(BVH_REDUCE)
    #undef BVH_REDUCE
    return value;
}

uint bvh_max(uint value) {
    #define BVH_REDUCE(step) value = max(value, subgroupShuffleXor(value, step))
    SCAN_STEPS(BVH_REDUCE)
    #undef BVH_REDUCE
    return value;
}

// How many threads' flags are set.
uint bvh_count(bool flag) {
    uint sum = flag ? 1u : 0u;
    #define BVH_REDUCE(step) sum += subgroupShuffleXor(sum, step)
    SCAN_STEPS(BVH_REDUCE)
    #undef BVH_REDUCE
    return sum;
}

// The lowest thread that is `ready`; the last one if none is.
uint bvh_leader(bool ready) {
    uint leader = ready ? gl_SubgroupInvocationID : WORKGROUP_SIZE - 1u;
    #define BVH_REDUCE(step) leader = min(leader, subgroupShuffleXor(leader, step))
    SCAN_STEPS(BVH_REDUCE)
    #undef BVH_REDUCE
    return leader;
}

#endif
