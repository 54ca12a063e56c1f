// A subgroup's rays walk the hierarchy together: the way for rays that have much in common (camera rays,
// shadow rays to one light in a small scene). A node is fetched once, each thread decodes one of its slots,
// and shuffles hand the boxes round; the stack lies across the threads' registers. For a workgroup that is
// one subgroup of at least eight threads, without instances.
#ifndef AJAR_BVH_PACKET_GLSL
#define AJAR_BVH_PACKET_GLSL
#include "bvh.glsl"
#include "bvh_reduce.glsl"

// Groups that wait: the i-th is in thread i % 8, register i / 8.
#define BVH_PACKET_REGISTERS ((BVH_STACK + 7u) / 8u)

struct BvhPacket {
    BvhWalk walk; // each thread's own ray and hit; cursor, depth and the box's key are the same in all
    uint waiting[BVH_PACKET_REGISTERS];
    bool halted; // some ray is in doubt; the same in all
};

bool bvh_packet_has_leaves(BvhPacket packet) {
    return bvh_has_leaves(packet.walk) && !(has_feature(FEATURE_ALPHA) && packet.halted);
}
bool bvh_packet_wants_node(BvhPacket packet) {
    return bvh_has_nodes(packet.walk) && !bvh_has_leaves(packet.walk) &&
           !(has_feature(FEATURE_ALPHA) && packet.halted);
}
bool bvh_packet_moves(BvhPacket packet) {
    return bvh_going(packet.walk) && !(has_feature(FEATURE_ALPHA) && packet.halted);
}

bool bvh_packets_possible() { return WORKGROUP_SIZE >= 8u && !has_feature(FEATURE_INSTANCES); }
uint bvh_packet_registers() {
    return STACK_REGISTERS > 0u ? (STACK_REGISTERS + 7u) / 8u : BVH_PACKET_REGISTERS;
}

float bvh_float_from(uint word, uint thread) { return uintBitsToFloat(subgroupShuffle(word, thread)); }

// One axis of the slot that a thread decodes, as steps: byte `shift` of one of two words that thread `from`
// fetched.
float bvh_packet_plane(uint first, uint second, uint from, uint slot) {
    uint low = subgroupShuffle(first, from); // never within a choice: all threads must take part
    uint high = subgroupShuffle(second, from);
    return float(int((slot < 4u ? low : high) >> 8u * (slot & 3u) & 0xffu));
}

// What any of the rays meets in a node. `one_octant`: all go the same way along each axis, so that near and
// far sides are told apart once for all of them.
NodeHits bvh_packet_node(uint node, BoxRay ray, float limit, const bool one_octant) {
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
    bvec3 forward = bvec3((ray.key & 1u) != 0u, (ray.key & 2u) != 0u, (ray.key & 4u) != 0u);
    vec3 near = one_octant ? mix(upper, lower, forward) : lower;
    vec3 far = one_octant ? mix(lower, upper, forward) : upper;
    float widen = one_octant ? BOX_FAR : 1.0; // else the far sides are known only further down
    vec3 far_inverse = ray.inverse * widen;
    vec3 far_offset = offset * widen;
    uint hits = 0u;
    for (uint s = 0u; s < BVH_WIDTH; ++s) {
        float x0 = subgroupShuffle(near.x, s) * ray.inverse.x + offset.x;
        float y0 = subgroupShuffle(near.y, s) * ray.inverse.y + offset.y;
        float z0 = subgroupShuffle(near.z, s) * ray.inverse.z + offset.z;
        float x1 = subgroupShuffle(far.x, s) * far_inverse.x + far_offset.x;
        float y1 = subgroupShuffle(far.y, s) * far_inverse.y + far_offset.y;
        float z1 = subgroupShuffle(far.z, s) * far_inverse.z + far_offset.z;
        float enter = box_max(box_max(x0, y0), z0);
        float leave = box_min(box_min(x1, y1), z1);
        if (!one_octant) {
            enter = box_max(box_max(box_min(x0, x1), box_min(y0, y1)), box_min(z0, z1));
            leave = box_min(box_min(box_max(x0, x1), box_max(y0, y1)), box_max(z0, z1)) * BOX_FAR;
        }
        leave = box_min(leave, limit);
        hits |= enter <= leave && leave >= BOX_NEAR ? ray.bits[s] : 0u;
    }
    return box_hits(bvh_or(hits),
                    uvec4(subgroupShuffle(mine.x, 1u), subgroupShuffle(mine.y, 1u),
                          subgroupShuffle(mine.z, 1u), subgroupShuffle(mine.w, 1u)),
                    ray);
}

// Visits the nearest pending node.
void bvh_packet_node_step(inout BvhPacket packet, const bool one_octant) {
    uint group = packet.walk.cursor.group;
    uint order = uint(findMSB(group & 0xffu));
    NodeHits hits = bvh_packet_node((group >> 8) + (order ^ packet.walk.box.key), packet.walk.box,
                                    box_min(packet.walk.hit.t, BVH_FAR) * BOX_FAR, one_octant);
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

// One coordinate of three vertices, from the thread that fetched it: each ray has its own order of axes.
vec3 bvh_packet_coordinates(uvec4 mine, uint thread) {
    return vec3(bvh_float_from(mine.x, thread), bvh_float_from(mine.y, thread),
                bvh_float_from(mine.z, thread));
}

void bvh_packet_triangle_step(BvhRay ray, inout BvhPacket packet, const bool any_hit) {
    uint triangle = bvh_take_leaf(packet.walk);
    uvec4 mine =
        fetch_triangle(triangle * TRIANGLE_TEXELS + min(gl_SubgroupInvocationID & 7u, TRIANGLE_TEXELS - 1u));
    uvec3 axes = packet.walk.shear.texels;
    vec3 x = bvh_packet_coordinates(mine, axes.x);
    vec3 y = bvh_packet_coordinates(mine, axes.y);
    vec3 z = bvh_packet_coordinates(mine, axes.z);
    TriangleHit test = triangle_test(packet.walk.shear, x, y, z);
    bvh_accept(ray, packet.walk, triangle, subgroupShuffle(mine.w, 0u), test, any_hit);
    if (has_feature(FEATURE_ALPHA)) packet.halted = bvh_or(bvh_in_doubt(packet.walk) ? 1u : 0u) != 0u;
}

void bvh_packet_start(inout BvhPacket packet) {
    packet.walk.cursor = BvhCursor(bvh_root_group(frame.root, packet.walk.box.key), 0u, 0u, 0u);
    packet.walk.depth = 0u;
    packet.halted = false;
    for (uint r = 0u; r < BVH_PACKET_REGISTERS; ++r) packet.waiting[r] = 0u;
}

// Towards the nearest hits of the rays whose limit is positive and that go into the packet's octant, until
// the packet is done or halted.
void bvh_walk_octant(BvhRay ray, inout BvhPacket packet, inout uint spent) {
    while (spent < BVH_BUDGET) {
        ++spent;
        while (spent < BVH_BUDGET) {
            ++spent;
            if (!has_feature(FEATURE_ALPHA) || bvh_packet_wants_node(packet))
                bvh_packet_node_step(packet, true);
            if (!bvh_packet_wants_node(packet)) break;
        }
        if (bvh_packet_has_leaves(packet)) {
            for (uint k = 0u; k < BVH_WIDTH * BVH_MAX_LEAF; ++k) {
                ++spent;
                bvh_packet_triangle_step(ray, packet, false);
                if (!bvh_packet_has_leaves(packet)) break;
            }
        }
        if (!bvh_packet_moves(packet)) break;
    }
}

// Traces rays 0 to count - 1 to their nearest hits; returns how many this thread could not finish. A packet
// is traced once for each octant that its directions are in: for camera rays that is one, but at the
// picture's middle. A packet that halts leaves the loops, settles what is in doubt and comes back: so packets
// that do not halt pay nothing for it.
uint bvh_trace_packets(uint count) {
    uint spent = 0u;
    uint unfinished = 0u;
    uint first = 0u;
    BvhRay ray;
    BvhPacket packet;
    packet.halted = false;
    uint own_key = 0u;
    bool waits = false;
    bool halted = false;
    const uint turns = has_feature(FEATURE_ALPHA) ? BVH_BUDGET : 1u;
    for (uint turn = 0u; turn < turns; ++turn) {
        for (; first < count; first += WORKGROUP_SIZE) {
            uint i = first + gl_SubgroupInvocationID;
            if (!has_feature(FEATURE_ALPHA) || !halted) {
                ray = bvh_ray_of(min(i, count - 1u));
                packet.walk = bvh_begin(ray);
                own_key = packet.walk.box.key;
                waits = i < count;
            }
            for (uint octant = 0u; octant < 8u; ++octant) {
                spent += 2u; // of which one for the loop around
                uint key = subgroupShuffle(own_key, bvh_leader(waits));
                bool now = waits && own_key == key;
                box_set_key(packet.walk.box, key);
                float limit = packet.walk.hit.t;
                packet.walk.hit.t = now ? limit : -1.0;
                if (!has_feature(FEATURE_ALPHA) || !halted) bvh_packet_start(packet);
                bvh_walk_octant(ray, packet, spent);
                halted = has_feature(FEATURE_ALPHA) && packet.halted && spent < BVH_BUDGET;
                packet.walk.hit.t = now ? packet.walk.hit.t : limit;
                unfinished += now && !halted && bvh_unfinished(packet.walk) ? 1u : 0u;
                waits = waits && (!now || halted);
                if (halted || bvh_or(waits ? 1u : 0u) == 0u) break;
            }
            if (halted) break;
            if (i < count) bvh_found(i, packet.walk.hit, true);
            if (first + WORKGROUP_SIZE >= count) break;
        }
        if (has_feature(FEATURE_ALPHA)) {
            bvh_settle(ray, packet.walk, false);
            packet.halted = false;
            ++spent;
            if (!halted) break;
        }
    }
    return unfinished;
}

#endif
