// A subgroup's rays walk the hierarchy together: the way for rays that have much in common (camera rays,
// shadow rays to one light). A node is fetched once, each thread decodes one of its slots, and shuffles hand
// the boxes round; the stack lies across the threads' registers. For a workgroup that is one subgroup of at
// least eight threads, without instances.
#ifndef AJAR_BVH_PACKET_GLSL
#define AJAR_BVH_PACKET_GLSL
#include "bvh.glsl"

// Groups that wait: the i-th is in thread i % 8, register i / 8.
#define BVH_PACKET_REGISTERS ((BVH_STACK + 7u) / 8u)
const uint BVH_PACKET_SHALLOW = 2u;

struct BvhPacket {
    BvhWalk walk; // each thread's own ray and hit; cursor and depth are the same in all
    uint waiting[BVH_PACKET_REGISTERS];
};

bool bvh_packets_possible() { return WORKGROUP_SIZE >= 8u && !has_feature(FEATURE_INSTANCES); }
uint bvh_packet_registers() { return bvh_shallow() ? BVH_PACKET_SHALLOW : BVH_PACKET_REGISTERS; }

uint bvh_or(uint value) {
    if (WORKGROUP_SIZE > 1u) value |= subgroupShuffleXor(value, 1u);
    if (WORKGROUP_SIZE > 2u) value |= subgroupShuffleXor(value, 2u);
    if (WORKGROUP_SIZE > 4u) value |= subgroupShuffleXor(value, 4u);
    if (WORKGROUP_SIZE > 8u) value |= subgroupShuffleXor(value, 8u);
    if (WORKGROUP_SIZE > 16u) value |= subgroupShuffleXor(value, 16u);
    if (WORKGROUP_SIZE > 32u) value |= subgroupShuffleXor(value, 32u);
    if (WORKGROUP_SIZE > 64u) value |= subgroupShuffleXor(value, 64u);
    return value;
}

float bvh_float_from(uint word, uint thread) { return uintBitsToFloat(subgroupShuffle(word, thread)); }

// One axis of the slot that a thread decodes, as steps: byte `shift` of one of two words that thread `from`
// fetched.
float bvh_packet_plane(uint first, uint second, uint from, uint slot) {
    uint word = slot < 4u ? subgroupShuffle(first, from) : subgroupShuffle(second, from);
    return float(int(word >> 8u * (slot & 3u) & 0xffu));
}

// What any of the rays meets in a node. The order is the first ray's.
NodeHits bvh_packet_node(uint node, BoxRay ray, float limit) {
    uint slot = gl_SubgroupInvocationID & 7u;
    uvec4 mine = fetch_node(node * BVH_NODE_TEXELS + min(slot, BVH_NODE_TEXELS - 1u));
    vec3 offset = (vec3(bvh_float_from(mine.x, 0u), bvh_float_from(mine.y, 0u), bvh_float_from(mine.z, 0u)) -
                   ray.origin) *
                  ray.inverse;
    vec3 step = box_steps(subgroupShuffle(mine.w, 0u));
    vec3 lower =
        step * vec3(bvh_packet_plane(mine.x, mine.y, 2u, slot), bvh_packet_plane(mine.z, mine.w, 2u, slot),
                    bvh_packet_plane(mine.x, mine.y, 3u, slot));
    vec3 upper =
        step * vec3(bvh_packet_plane(mine.z, mine.w, 3u, slot), bvh_packet_plane(mine.x, mine.y, 4u, slot),
                    bvh_packet_plane(mine.z, mine.w, 4u, slot));
    uint hits = 0u;
    for (uint s = 0u; s < BVH_WIDTH; ++s) {
        float x0 = subgroupShuffle(lower.x, s) * ray.inverse.x + offset.x;
        float y0 = subgroupShuffle(lower.y, s) * ray.inverse.y + offset.y;
        float z0 = subgroupShuffle(lower.z, s) * ray.inverse.z + offset.z;
        float x1 = subgroupShuffle(upper.x, s) * ray.inverse.x + offset.x;
        float y1 = subgroupShuffle(upper.y, s) * ray.inverse.y + offset.y;
        float z1 = subgroupShuffle(upper.z, s) * ray.inverse.z + offset.z;
        float near = box_max(box_max(box_min(x0, x1), box_min(y0, y1)), box_max(box_min(z0, z1), BOX_NEAR));
        float far = box_min(box_min(box_max(x0, x1), box_max(y0, y1)), box_max(z0, z1)) * BOX_FAR;
        hits |= near <= box_min(far, limit) ? ray.bits[s] : 0u;
    }
    return box_hits(bvh_or(hits),
                    uvec4(subgroupShuffle(mine.x, 1u), subgroupShuffle(mine.y, 1u),
                          subgroupShuffle(mine.z, 1u), subgroupShuffle(mine.w, 1u)),
                    ray);
}

// Visits the nearest pending node.
void bvh_packet_node_step(inout BvhPacket packet) {
    uint group = packet.walk.cursor.group;
    uint order = uint(findMSB(group & 0xffu));
    NodeHits hits = bvh_packet_node((group >> 8) + (order ^ packet.walk.box.key), packet.walk.box,
                                    box_min(packet.walk.hit.t, BVH_FAR) * BOX_FAR);
    uint rest = group & ~(1u << order);
    bool deeper = (hits.group & 0xffu) != 0u;
    bool more = (rest & 0xffu) != 0u;
    bool pushes = deeper && more;
    bool pops = !deeper && !more;
    uint lane = gl_SubgroupInvocationID & 7u;
    uint top = packet.walk.depth - 1u;
    uint next = 0u;
    for (uint r = 0u; r < bvh_packet_registers(); ++r) {
        uint waiting = subgroupShuffle(packet.waiting[r], top & 7u);
        next = top >> 3 == r ? waiting : next; // 0 below the first
        packet.waiting[r] = pushes && packet.walk.depth == 8u * r + lane ? rest : packet.waiting[r];
    }
    packet.walk.cursor = BvhCursor(deeper ? hits.group
                                   : more ? rest
                                          : next,
                                   hits.triangle_base, hits.leaves, hits.leaf_hits);
    packet.walk.depth += pushes ? 1u : pops && packet.walk.depth > 0u ? 0xffffffffu : 0u;
}

// One coordinate of three vertices, from the thread that fetched it.
vec3 bvh_packet_coordinates(uvec4 mine, uint thread) {
    return vec3(bvh_float_from(mine.x, thread), bvh_float_from(mine.y, thread),
                bvh_float_from(mine.z, thread));
}

void bvh_packet_triangle_step(BvhRay ray, inout BvhPacket packet, const bool any_hit) {
    uint triangle = bvh_take_leaf(packet.walk);
    uvec4 mine =
        fetch_triangle(triangle * TRIANGLE_TEXELS + min(gl_SubgroupInvocationID & 7u, TRIANGLE_TEXELS - 1u));
    vec3 x = bvh_packet_coordinates(mine, 0u);
    vec3 y = bvh_packet_coordinates(mine, 1u);
    vec3 z = bvh_packet_coordinates(mine, 2u);
    uvec3 texels = packet.walk.shear.texels;
    bool main_x = texels.z == 0u;
    bool main_y = texels.z == 1u;
    TriangleHit test = triangle_test(packet.walk.shear,
                                     main_x   ? y
                                     : main_y ? z
                                              : x,
                                     main_x   ? z
                                     : main_y ? x
                                              : y,
                                     main_x   ? x
                                     : main_y ? y
                                              : z);
    bvh_accept(ray, packet.walk, triangle, subgroupShuffle(mine.w, 0u), test, any_hit);
}

uint bvh_trace_packets(uint count, const bool any_hit) {
    uint spent = 0u;
    uint unfinished = 0u;
    for (uint first = 0u; first < count; first += WORKGROUP_SIZE) {
        uint i = first + gl_SubgroupInvocationID;
        BvhRay ray = bvh_ray_of(min(i, count - 1u));
        BvhPacket packet;
        packet.walk = bvh_begin(ray);
        box_set_key(packet.walk.box, subgroupShuffle(packet.walk.box.key, 0u));
        packet.walk.cursor.group = bvh_root_group(frame.root, packet.walk.box.key);
        packet.walk.hit.t = i < count ? packet.walk.hit.t : -1.0;
        for (uint r = 0u; r < BVH_PACKET_REGISTERS; ++r) packet.waiting[r] = 0u;
        for (uint round = 0u; round < BVH_BUDGET; ++round) {
            for (uint k = 0u; k < BVH_BUDGET; ++k) {
                ++spent;
                bvh_packet_node_step(packet);
                if (!bvh_wants_node(packet.walk)) break;
            }
            if (bvh_has_leaves(packet.walk)) {
                for (uint k = 0u; k < BVH_WIDTH * BVH_MAX_LEAF; ++k) {
                    ++spent;
                    bvh_packet_triangle_step(ray, packet, any_hit);
                    if (!bvh_has_leaves(packet.walk)) break;
                }
            }
            ++spent;
            // Rays that are done have a negative limit and meet nothing more.
            if (any_hit && bvh_or(packet.walk.hit.t > 0.0 ? 1u : 0u) == 0u) packet.walk.cursor.group = 0u;
            if (!bvh_going(packet.walk) || spent > BVH_BUDGET) break;
        }
        unfinished += bvh_going(packet.walk) && i < count ? 1u : 0u;
        if (i < count) bvh_found(i, packet.walk.hit, true);
        if (first + WORKGROUP_SIZE >= count) break;
    }
    return unfinished;
}

#endif
