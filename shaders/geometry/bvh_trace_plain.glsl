// The portable way: each thread takes every WORKGROUP_SIZE-th ray and sees it through. Every loop is bounded,
// as lavapipe (Mesa 22.3) ends all loops of an invocation after 65,535 iterations, silently.
#ifndef AJAR_BVH_TRACE_PLAIN_GLSL
#define AJAR_BVH_TRACE_PLAIN_GLSL

// Steps per ray that keep all rays of an invocation together below that limit.
uint bvh_step_limit() {
    return clamp(60000u * WORKGROUP_SIZE * TRACE_SHARES / SEGMENT_SIZE, 64u, 16384u);
}

// Walks until the ray is done or in doubt. Loops test at their end, as lavapipe runs a body once more, for
// nobody, where a test at the head fails.
void bvh_walk(BvhRay ray, inout BvhWalk walk, inout uint steps, const bool any_hit) {
    const uint limit = bvh_step_limit();
    for (uint round = 0u; round < limit; ++round) {
        if (bvh_wants_node(walk)) {
            for (uint i = 0u; i < limit; ++i) {
                ++steps;
                bvh_node_step(walk);
                if (!bvh_wants_node(walk)) break;
            }
        }
        if (bvh_wants_triangle(walk)) {
            for (uint i = 0u; i < limit; ++i) {
                bvh_triangle_step(ray, walk, any_hit);
                if (!bvh_wants_triangle(walk)) break;
            }
        }
        if (has_feature(FEATURE_INSTANCES)) bvh_instance_step(ray, walk, any_hit);
        ++steps;
        if (!bvh_going(walk) || bvh_in_doubt(walk) || steps > limit) break;
    }
}

Hit bvh_trace(BvhRay ray, const bool any_hit, out bool exhausted) {
    BvhWalk walk = bvh_begin(ray);
    uint steps = 0u;
    if (!has_feature(FEATURE_ALPHA)) {
        bvh_walk(ray, walk, steps, any_hit);
    } else {
        const uint limit = bvh_step_limit();
        for (uint turn = 0u; turn < limit; ++turn) {
            bvh_walk(ray, walk, steps, any_hit);
            bvh_settle(ray, walk, any_hit);
            bvh_stop_if_hit(walk, any_hit);
            ++steps;
            if (!bvh_going(walk) || steps > limit) break;
        }
    }
    exhausted = bvh_going(walk);
    return walk.hit;
}

// Traces rays 0 to count - 1; returns how many this thread could not finish.
uint bvh_trace_all(uint count, const bool together, const bool any_hit) {
    uint unfinished = 0u;
    for (uint i = gl_LocalInvocationID.x; i < count; i += WORKGROUP_SIZE) {
        bool exhausted;
        Hit hit = bvh_trace(bvh_ray_of(i), any_hit, exhausted);
        bvh_found(i, hit, true);
        unfinished += exhausted ? 1u : 0u;
        if (i + WORKGROUP_SIZE >= count) break;
    }
    return unfinished;
}

#endif
