// Order-preserving compaction within a workgroup: every thread that keeps its item learns how many before it
// do. AJAR_SUBGROUP: the workgroup is one subgroup of known size, so shuffles do (5 ns per 8 lanes on
// lavapipe); elsewhere shared memory (11 ns) and no assumption about subgroups.
#ifndef AJAR_SCAN_GLSL
#define AJAR_SCAN_GLSL

#ifdef AJAR_SUBGROUP
#extension GL_KHR_shader_subgroup_shuffle : require
#extension GL_KHR_shader_subgroup_basic : require
#else
shared uint scan_words[32];
#endif

struct Scan {
    uint before; // keepers with a lower thread index
    uint total;  // keepers in the workgroup
};

#ifdef AJAR_SUBGROUP
// STEP(1u), STEP(2u), STEP(4u) and so on below the subgroup's size: what a sum over it, or any other
// reduction, takes. Written out, as Mesa 22.3 does not unroll a loop that shifts its counter.
#define SCAN_STEPS(STEP)               \
    if (WORKGROUP_SIZE > 1u) STEP(1u); \
    if (WORKGROUP_SIZE > 2u) STEP(2u); \
    if (WORKGROUP_SIZE > 4u) STEP(4u); \
    if (WORKGROUP_SIZE > 8u) STEP(8u); \
    if (WORKGROUP_SIZE > 16u) STEP(16u); \
    if (WORKGROUP_SIZE > 32u) STEP(32u); \
    if (WORKGROUP_SIZE > 64u) STEP(64u);

uint scan_step(uint sum, uint lane, uint step) {
    uint other = subgroupShuffle(sum, (lane - step) & (WORKGROUP_SIZE - 1u));
    return sum + (lane >= step ? other : 0u);
}
#endif

// Where a thread's item goes: keepers first, in order, then the others. Storing those too, into places that
// hold nothing any more, leaves no store under a mask: on lavapipe that is a branch per thread, and which
// threads keep their item cannot be predicted (shade: 12 % faster).
uint scan_place(Scan scan, bool keep) {
    return keep ? scan.before : scan.total + gl_LocalInvocationID.x - scan.before;
}

// What the workgroup's threads wrote to shared memory is there for all of them afterwards, and what they
// write next comes later. To be called by all, under uniform control flow.
void scan_barrier() {
#ifdef AJAR_SUBGROUP
    subgroupBarrier();
#else
    barrier();
#endif
}

// All threads of the workgroup must call it, under uniform control flow. Reads before the call are done
// before any thread's writes after it.
Scan scan_keepers(bool keep) {
    Scan scan;
#ifdef AJAR_SUBGROUP
    uint lane = gl_SubgroupInvocationID;
    uint sum = keep ? 1u : 0u;
    #define SCAN_SUM(step) sum = scan_step(sum, lane, step)
    SCAN_STEPS(SCAN_SUM)
    #undef SCAN_SUM
    scan.before = sum - (keep ? 1u : 0u);
    scan.total = subgroupShuffle(sum, WORKGROUP_SIZE - 1u);
#else
    // One bit per thread; workgroups have at most 1024 threads.
    uint lane = gl_LocalInvocationID.x;
    uint words = (WORKGROUP_SIZE + 31u) / 32u;
    if (lane < words) scan_words[lane] = 0u;
    barrier();
    if (keep) atomicOr(scan_words[lane >> 5], 1u << (lane & 31u));
    barrier();
    scan.before = 0u;
    scan.total = 0u;
    for (uint w = 0u; w < words; ++w) {
        uint bits = scan_words[w];
        scan.total += uint(bitCount(bits));
        uint lower = w < (lane >> 5) ? bits : w == (lane >> 5) ? bits & ((1u << (lane & 31u)) - 1u) : 0u;
        scan.before += uint(bitCount(lower));
    }
    barrier();
#endif
    return scan;
}

#endif
