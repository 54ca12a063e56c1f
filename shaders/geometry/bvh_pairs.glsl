// Shadow rays that have much in common: two packets in turn, as every step of one waits for memory and for
// its own results, and a CPU works on the other meanwhile.
#ifndef AJAR_BVH_PAIRS_GLSL
#define AJAR_BVH_PAIRS_GLSL
#include "bvh_packet.glsl"

// Rays that are done have a negative limit and meet nothing more.
void bvh_packet_stop_if_done(inout BvhPacket packet) {
    if (bvh_or(packet.walk.hit.t > 0.0 ? 1u : 0u) == 0u) {
        packet.walk.cursor.group = 0u;
        packet.walk.cursor.leaf_hits = 0u;
    }
}

// Whether anything is in the way of the rays whose limit is positive: until both packets are done or halted.
void bvh_walk_pair(BvhRay ray_a, BvhRay ray_b, inout BvhPacket a, inout BvhPacket b, inout uint spent) {
    while (spent < BVH_BUDGET) {
        ++spent;
        while (spent < BVH_BUDGET) {
            ++spent;
            if (bvh_packet_wants_node(a)) bvh_packet_node_step(a, false);
            if (bvh_packet_wants_node(b)) bvh_packet_node_step(b, false);
            if (!bvh_packet_wants_node(a) && !bvh_packet_wants_node(b)) break;
        }
        if (bvh_packet_has_leaves(a) || bvh_packet_has_leaves(b)) {
            for (uint k = 0u; k < BVH_WIDTH * BVH_MAX_LEAF; ++k) {
                ++spent;
                if (bvh_packet_has_leaves(a)) bvh_packet_triangle_step(ray_a, a, true);
                if (bvh_packet_has_leaves(b)) bvh_packet_triangle_step(ray_b, b, true);
                if (!bvh_packet_has_leaves(a) && !bvh_packet_has_leaves(b)) break;
            }
        }
        bvh_packet_stop_if_done(a);
        bvh_packet_stop_if_done(b);
        if (!bvh_packet_moves(a) && !bvh_packet_moves(b)) break;
    }
}

// A packet of shadow rays, which may go into several octants; the order is the first ray's.
BvhPacket bvh_shadow_packet(BvhRay ray, bool exists) {
    BvhPacket packet;
    packet.walk = bvh_begin(ray);
    box_set_key(packet.walk.box, subgroupShuffle(packet.walk.box.key, 0u));
    packet.walk.hit.t = exists ? packet.walk.hit.t : -1.0;
    bvh_packet_start(packet);
    return packet;
}

void bvh_settle_packet(BvhRay ray, inout BvhPacket packet) {
    bvh_settle(ray, packet.walk, true);
    packet.halted = false;
    bvh_packet_stop_if_done(packet);
}

// Traces rays 0 to count - 1 to any hit; returns how many this thread could not finish.
uint bvh_trace_pairs(uint count) {
    uint spent = 0u;
    uint unfinished = 0u;
    uint first = 0u;
    BvhRay ray_a, ray_b;
    BvhPacket a, b;
    bool halted = false;
    const uint turns = has_feature(FEATURE_ALPHA) ? BVH_BUDGET : 1u;
    for (uint turn = 0u; turn < turns; ++turn) {
        for (; first < count; first += 2u * WORKGROUP_SIZE) {
            uint i = first + gl_SubgroupInvocationID;
            uint j = i + WORKGROUP_SIZE;
            if (!halted) {
                ray_a = bvh_ray_of(min(i, count - 1u));
                ray_b = bvh_ray_of(min(j, count - 1u));
                a = bvh_shadow_packet(ray_a, i < count);
                b = bvh_shadow_packet(ray_b, j < count);
            }
            ++spent;
            bvh_walk_pair(ray_a, ray_b, a, b, spent);
            halted = has_feature(FEATURE_ALPHA) && (a.halted || b.halted) && spent < BVH_BUDGET;
            if (halted) break;
            unfinished += bvh_unfinished(a.walk) && i < count ? 1u : 0u;
            unfinished += bvh_unfinished(b.walk) && j < count ? 1u : 0u;
            if (i < count) bvh_found(i, a.walk.hit, true);
            if (j < count) bvh_found(j, b.walk.hit, true);
            if (first + 2u * WORKGROUP_SIZE >= count) break;
        }
        if (has_feature(FEATURE_ALPHA)) {
            bvh_settle_packet(ray_a, a);
            bvh_settle_packet(ray_b, b);
            ++spent;
            if (!halted) break;
        }
    }
    return unfinished;
}

#endif
