// Shadow rays that have much in common: two packets in turn, as every step of one waits for memory and for
// its own results, and a CPU works on the other meanwhile. For scenes where no triangle is in doubt.
#ifndef AJAR_BVH_PAIRS_GLSL
#define AJAR_BVH_PAIRS_GLSL
#include "bvh_packet.glsl"

bool bvh_pairs_possible() { return bvh_packets_possible() && !has_feature(FEATURE_ALPHA); }

// Rays that are done have a negative limit and meet nothing more.
void bvh_packet_stop_if_done(inout BvhPacket packet) {
    if (bvh_or(packet.walk.hit.t > 0.0 ? 1u : 0u) == 0u) packet.walk.cursor.group = 0u;
}

// Whether anything is in the way of the rays whose limit is positive.
void bvh_trace_pair(BvhRay ray_a, BvhRay ray_b, inout BvhPacket a, inout BvhPacket b, inout uint spent) {
    bvh_packet_start(a);
    bvh_packet_start(b);
    for (; spent < BVH_BUDGET; spent += 1u + BVH_WIDTH * BVH_MAX_LEAF) {
        for (; spent < BVH_BUDGET; ++spent) {
            if (bvh_wants_node(a.walk)) bvh_packet_node_step(a, false);
            if (bvh_wants_node(b.walk)) bvh_packet_node_step(b, false);
            if (!bvh_wants_node(a.walk) && !bvh_wants_node(b.walk)) break;
        }
        if (bvh_has_leaves(a.walk) || bvh_has_leaves(b.walk)) {
            for (uint k = 0u; k < BVH_WIDTH * BVH_MAX_LEAF; ++k) {
                if (bvh_has_leaves(a.walk)) bvh_packet_triangle_step(ray_a, a, true);
                if (bvh_has_leaves(b.walk)) bvh_packet_triangle_step(ray_b, b, true);
                if (!bvh_has_leaves(a.walk) && !bvh_has_leaves(b.walk)) break;
            }
        }
        bvh_packet_stop_if_done(a);
        bvh_packet_stop_if_done(b);
        if (!bvh_going(a.walk) && !bvh_going(b.walk)) break;
    }
}

// A packet of shadow rays, which may go into several octants; the order is the first ray's.
BvhPacket bvh_shadow_packet(BvhRay ray, bool exists) {
    BvhPacket packet;
    packet.walk = bvh_begin(ray);
    box_set_key(packet.walk.box, subgroupShuffle(packet.walk.box.key, 0u));
    packet.walk.hit.t = exists ? packet.walk.hit.t : -1.0;
    return packet;
}

// Traces rays 0 to count - 1 to any hit; returns how many this thread could not finish.
uint bvh_trace_pairs(uint count) {
    uint spent = 0u;
    uint unfinished = 0u;
    for (uint first = 0u; first < count; first += 2u * WORKGROUP_SIZE) {
        uint i = first + gl_SubgroupInvocationID;
        uint j = i + WORKGROUP_SIZE;
        BvhRay ray_a = bvh_ray_of(min(i, count - 1u));
        BvhRay ray_b = bvh_ray_of(min(j, count - 1u));
        BvhPacket a = bvh_shadow_packet(ray_a, i < count);
        BvhPacket b = bvh_shadow_packet(ray_b, j < count);
        bvh_trace_pair(ray_a, ray_b, a, b, spent);
        unfinished += bvh_going(a.walk) && i < count ? 1u : 0u;
        unfinished += bvh_going(b.walk) && j < count ? 1u : 0u;
        if (i < count) bvh_found(i, a.walk.hit, true);
        if (j < count) bvh_found(j, b.walk.hit, true);
        if (first + 2u * WORKGROUP_SIZE >= count) break;
    }
    return unfinished;
}

#endif
