// Where the workgroup is one subgroup of known size: a thread whose ray is done takes the next one, so that
// fewer threads idle while others finish (Aila and Laine 2009, "Understanding the Efficiency of Ray Traversal
// on GPUs"). All loops but that over triangles are left by all threads together. They test at their end, as
// lavapipe runs a body once more, for nobody, where a test at the head fails.
#ifndef AJAR_BVH_TRACE_SUBGROUP_GLSL
#define AJAR_BVH_TRACE_SUBGROUP_GLSL
#include "bvh_reduce.glsl"

// Below this the driver's own limit of 65,535 iterations per invocation is not reached (Mesa 22.3).
const uint BVH_BUDGET = 60000u;

#include "bvh_pairs.glsl"

const uint BVH_NONE = 0xffffffffu;
// As many rays as this halt before they look at what is in doubt. Measured on lavapipe: 2 of 8, of 1 to 4; a
// few per cent lie between them.
const uint BVH_DOUBTS = (WORKGROUP_SIZE + 3u) / 4u;

bool bvh_moves(BvhWalk walk) { return bvh_going(walk) && !bvh_in_doubt(walk); }

// Walks on while it is worth while: where there are `more` rays, as long as most threads have work. Returns
// how many still have.
uint bvh_walk(BvhRay ray, inout BvhWalk walk, inout uint spent, bool more, const bool any_hit) {
    uint few = more ? WORKGROUP_SIZE * 3u / 8u : 0u;
    uint half_full = more ? WORKGROUP_SIZE / 2u : 0u;
    uint busy = 0u;
    for (uint run = 0u; run < BVH_BUDGET; ++run) {
        for (uint i = 0u; i < BVH_BUDGET; ++i) {
            ++spent;
            if (bvh_wants_node(walk)) bvh_node_step(walk);
            if (bvh_count(bvh_wants_node(walk)) <= few) break;
        }
        uint tried = 0u;
        if (bvh_wants_triangle(walk)) {
            for (uint i = 0u; i < BVH_WIDTH * BVH_MAX_LEAF; ++i) {
                ++tried;
                bvh_triangle_step(ray, walk, any_hit);
                if (!bvh_wants_triangle(walk)) break;
            }
        }
        // Rays that halt spend more rounds: counted exactly, which costs a little.
        spent += 1u + (has_feature(FEATURE_ALPHA) ? bvh_max(tried) : BVH_WIDTH * BVH_MAX_LEAF);
        if (has_feature(FEATURE_INSTANCES)) bvh_instance_step(ray, walk, any_hit);
        busy = bvh_count(bvh_moves(walk));
        if (busy <= half_full || spent > BVH_BUDGET) break;
    }
    return busy;
}

// What is in doubt is settled outside the loop over rounds, which does not pay for it so.
uint bvh_trace_replacing(uint count, const bool any_hit) {
    uint next = 0u;
    uint slot = BVH_NONE; // of this thread's ray
    uint spent = 0u;
    BvhRay ray;
    BvhWalk walk;
    walk.cursor = BvhCursor(0u, 0u, 0u, 0u);
    walk.doubt.triangle = NO_TRIANGLE;
    const uint turns = has_feature(FEATURE_ALPHA) ? BVH_BUDGET : 1u;
    for (uint turn = 0u; turn < turns; ++turn) {
        for (uint round = 0u; round < BVH_BUDGET; ++round) {
            if (has_feature(FEATURE_ALPHA)) ++spent;
            bool idle = !bvh_unfinished(walk);
            if (slot != BVH_NONE) {
                bvh_found(slot, walk.hit, idle);
                slot = idle ? BVH_NONE : slot;
            }
            Scan free = scan_keepers(idle);
            if (idle && next + free.before < count) {
                slot = next + free.before;
                ray = bvh_ray_of(slot);
                walk = bvh_begin(ray);
            }
            next = min(next + free.total, count);
            uint busy = bvh_walk(ray, walk, spent, next < count, any_hit);
            if ((next >= count && busy == 0u) || spent > BVH_BUDGET) break;
            if (has_feature(FEATURE_ALPHA)) {
                if (bvh_count(bvh_in_doubt(walk)) >= BVH_DOUBTS) break;
            }
        }
        if (has_feature(FEATURE_ALPHA)) {
            ++spent;
            bvh_settle(ray, walk, any_hit);
            bvh_stop_if_hit(walk, any_hit);
            if ((next >= count && bvh_count(bvh_going(walk)) == 0u) || spent > BVH_BUDGET) break;
        }
    }
    uint unfinished = 0u;
    if (slot != BVH_NONE) {
        unfinished += bvh_going(walk) ? 1u : 0u;
        bvh_found(slot, walk.hit, true);
    }
    for (uint i = next + gl_LocalInvocationID.x; i < count; i += WORKGROUP_SIZE) {
        ++unfinished;
        bvh_found(i, Hit(BVH_FAR, NO_TRIANGLE, 0u, 0.0, 0.0), true);
    }
    return unfinished;
}

// `together`: neighbouring rays are similar.
uint bvh_trace_all(uint count, const bool together, const bool any_hit) {
    if (together && any_hit && bvh_pairs_possible()) return bvh_trace_pairs(count);
    if (together && !any_hit && bvh_packets_possible()) return bvh_trace_packets(count);
    return bvh_trace_replacing(count, any_hit);
}

#endif
