// Walking a hierarchy with one ray per thread, step by step; bvh_trace.glsl makes loops of the steps. Which
// steps are taken together shows in no hit: equal distances go to the lower triangle.
#ifndef AJAR_BVH_GLSL
#define AJAR_BVH_GLSL
#include "alpha.glsl"
#include "bvh_node.glsl"
#include "triangle.glsl"

struct Hit {
    float t;       // of the ray as given, metres; the limit where there is no hit
    uint triangle; // NO_TRIANGLE: none
    uint instance;
    float u;
    float v;
};

struct BvhRay {
    vec3 origin;
    vec3 direction;
    float limit;   // hits at or beyond it do not count
    uint leaves;   // never hit: the triangle the ray leaves
    uint instance; // that one's
    uint salt;     // random bits, for stochastic alpha
};

// What is still to do.
struct BvhCursor {
    uint group; // nodes, as in NodeHits
    uint triangle_base;
    uint leaves;
    uint leaf_hits; // triangles, or instances in the hierarchy over instances
};

// FEATURE_ALPHA: a triangle that is met, but may not be there. To look is dear, and on lavapipe every thread
// pays for one that does, at every step where one might. So the walk halts here until others have got as far,
// and they look outside the loops (bvh_settle).
struct BvhDoubt {
    uint triangle; // NO_TRIANGLE: none
    uint instance;
    float t;
    float u;
    float v;
    bool back_face;
};

#define BVH_STACK (2u * BVH_MAX_DEPTH + 1u)
const uint BVH_NO_INSTANCE = 0xffffffffu; // in the hierarchy over instances
const float BVH_FAR = 3.0e38;             // finite, so that a limit times a margin is

// Groups whose turn comes later. Where the hierarchy is shallow, as almost always, they are in registers, the
// next one first: on lavapipe moving all of them costs less than one store to a different place for every
// thread.
uint bvh_stack[BVH_STACK]; // elsewhere; the next one last. In two-level scenes each level has its part

// A ray under way, in the frame in which it is at the moment.
struct BvhWalk {
    BoxRay box;
    TriangleRay shear;
    uint instance;
    BvhCursor cursor;
    uint waiting[BVH_REGISTERS];
    uint depth;      // entries on bvh_stack
    uint floor;      // those below belong to the hierarchy over instances
    BvhCursor above; // the leaf there from which the ray came into this instance
    Hit hit;
    BvhDoubt doubt;
};

bool bvh_in_doubt(BvhWalk walk) {
    return has_feature(FEATURE_ALPHA) && walk.doubt.triangle != NO_TRIANGLE;
}
bool bvh_has_nodes(BvhWalk walk) { return (walk.cursor.group & 0xffu) != 0u; }
bool bvh_has_leaves(BvhWalk walk) { return walk.cursor.leaf_hits != 0u; }
bool bvh_wants_node(BvhWalk walk) {
    return bvh_has_nodes(walk) && !bvh_has_leaves(walk) && !bvh_in_doubt(walk);
}
bool bvh_wants_triangle(BvhWalk walk) {
    return bvh_has_leaves(walk) && (!has_feature(FEATURE_INSTANCES) || walk.instance != BVH_NO_INSTANCE) &&
           !bvh_in_doubt(walk);
}
bool bvh_going(BvhWalk walk) { return bvh_has_nodes(walk) || bvh_has_leaves(walk); }
bool bvh_unfinished(BvhWalk walk) { return bvh_going(walk) || bvh_in_doubt(walk); }

// The group that holds nothing but a root.
uint bvh_root_group(uint node, uint key) { return node << 8 | 1u << key; }
uint bvh_root(uint instance) { return fetch_instance(instance * INSTANCE_TEXELS + 6u).x; }

void bvh_enter_frame(inout BvhWalk walk, vec3 origin, vec3 direction, uint instance) {
    walk.box = box_ray(origin, direction);
    walk.shear = triangle_ray(origin, direction);
    walk.instance = instance;
}

BvhWalk bvh_begin(BvhRay ray) {
    BvhWalk walk;
    bvh_enter_frame(walk, ray.origin, ray.direction, 0u);
    walk.cursor = BvhCursor(bvh_root_group(frame.root, walk.box.key), 0u, 0u, 0u);
    walk.above = BvhCursor(0u, 0u, 0u, 0u);
    for (uint i = 0u; i < BVH_REGISTERS; ++i) walk.waiting[i] = 0u;
    walk.depth = 0u;
    walk.floor = 0u;
    walk.hit = Hit(ray.limit, NO_TRIANGLE, 0u, 0.0, 0.0);
    walk.doubt = BvhDoubt(NO_TRIANGLE, 0u, 0.0, 0.0, 0.0, false);
    if (has_feature(FEATURE_INSTANCES)) {
        // The world first; below it waits the hierarchy over instances.
        bvh_stack[0] = walk.cursor.group;
        walk.depth = 1u;
        walk.floor = 1u;
        walk.cursor.group = bvh_root_group(bvh_root(0u), walk.box.key);
    }
    return walk;
}

void bvh_push(inout BvhWalk walk, uint group) {
    bvh_stack[walk.depth] = group;
    ++walk.depth;
}

void bvh_pop(inout BvhWalk walk) {
    --walk.depth;
    walk.cursor.group = bvh_stack[walk.depth];
}

// Visits the nearest pending node. Needs bvh_wants_node().
void bvh_node_step(inout BvhWalk walk) {
    uint group = walk.cursor.group;
    uint order = uint(findMSB(group & 0xffu));
    NodeHits hits =
        box_node((group >> 8) + (order ^ walk.box.key), walk.box, box_min(walk.hit.t, BVH_FAR) * BOX_FAR);
    uint rest = group & ~(1u << order);
    bool deeper = (hits.group & 0xffu) != 0u;
    bool more = (rest & 0xffu) != 0u;
    walk.cursor = BvhCursor(deeper ? hits.group : rest, hits.triangle_base, hits.leaves, hits.leaf_hits);
    bool pushes = deeper && more;
    bool pops = !deeper && !more;
    if (STACK_REGISTERS > 0u) {
        walk.cursor.group = pops ? walk.waiting[0] : walk.cursor.group;
        uint before = rest;
        for (uint i = 0u; i < BVH_REGISTERS; ++i) {
            if (i < STACK_REGISTERS) {
                uint now = walk.waiting[i];
                uint after = i + 1u < STACK_REGISTERS ? walk.waiting[min(i + 1u, BVH_REGISTERS - 1u)] : 0u;
                walk.waiting[i] = pushes ? before : pops ? after : now;
                before = now;
            }
        }
    } else {
        if (pushes) bvh_push(walk, rest);
        if (pops && walk.depth > walk.floor) bvh_pop(walk);
    }
}

// Takes one pending leaf entry: its index.
uint bvh_take_leaf(inout BvhWalk walk) {
    uint bit = 1u << uint(findMSB(walk.cursor.leaf_hits));
    walk.cursor.leaf_hits &= ~bit;
    return walk.cursor.triangle_base + uint(bitCount(walk.cursor.leaves & (bit - 1u)));
}

bool bvh_excluded(BvhRay ray, uint triangle, uint instance) {
    return triangle == ray.leaves && (!has_feature(FEATURE_INSTANCES) || instance == ray.instance);
}

void bvh_take_hit(inout BvhWalk walk, bool found, uint triangle, uint instance, float t, float u, float v,
                  const bool any_hit) {
    walk.hit.triangle = found ? triangle : walk.hit.triangle;
    if (any_hit) { // all there is to know: nothing is nearer than this
        walk.hit.t = found ? -1.0 : walk.hit.t;
    } else {
        walk.hit.t = found ? t : walk.hit.t;
        walk.hit.instance = found ? instance : walk.hit.instance;
        walk.hit.u = found ? u : walk.hit.u;
        walk.hit.v = found ? v : walk.hit.v;
    }
}

// Takes a triangle that was tested as the hit, if it is nearer than the present one, or as the one in doubt.
void bvh_accept(BvhRay ray, inout BvhWalk walk, uint triangle, uint flags, TriangleHit test,
                const bool any_hit) {
    bool lower = triangle < walk.hit.triangle;
    if (has_feature(FEATURE_INSTANCES))
        lower = walk.instance < walk.hit.instance || (walk.instance == walk.hit.instance && lower);
    bool closer = test.t < walk.hit.t || (test.t == walk.hit.t && walk.hit.triangle != NO_TRIANGLE && lower);
    if (any_hit) closer = test.t < walk.hit.t;
    bool found = test.inside && closer && !bvh_excluded(ray, triangle, walk.instance);
    if (has_feature(FEATURE_ALPHA)) {
        bool unsure = found && (flags & TRIANGLE_ALPHA) != 0u;
        walk.doubt.triangle = unsure ? triangle : walk.doubt.triangle;
        walk.doubt.instance = unsure ? walk.instance : walk.doubt.instance;
        walk.doubt.t = unsure ? test.t : walk.doubt.t;
        walk.doubt.u = unsure ? test.u : walk.doubt.u;
        walk.doubt.v = unsure ? test.v : walk.doubt.v;
        walk.doubt.back_face = unsure ? test.back_face : walk.doubt.back_face;
        found = found && !unsure;
    }
    bvh_take_hit(walk, found, triangle, walk.instance, test.t, test.u, test.v, any_hit);
}

// Looks whether the triangle in doubt is there.
void bvh_settle(BvhRay ray, inout BvhWalk walk, const bool any_hit) {
    BvhDoubt doubt = walk.doubt;
    bool found = false;
    if (doubt.triangle != NO_TRIANGLE) // the side is that of the mesh's own frame, mirrored or not
        found = alpha_passes(doubt.triangle, doubt.instance, doubt.u, doubt.v, doubt.back_face, ray.salt);
    bvh_take_hit(walk, found, doubt.triangle, doubt.instance, doubt.t, doubt.u, doubt.v, any_hit);
    walk.doubt.triangle = NO_TRIANGLE;
}

// Ends a walk that needs no more than any hit.
void bvh_stop_if_hit(inout BvhWalk walk, const bool any_hit) {
    if (any_hit && walk.hit.triangle != NO_TRIANGLE) {
        walk.cursor.group = 0u;
        walk.cursor.leaf_hits = 0u;
    }
}

// Tries one pending triangle. Needs bvh_wants_triangle().
void bvh_triangle_step(BvhRay ray, inout BvhWalk walk, const bool any_hit) {
    uint triangle = bvh_take_leaf(walk);
    uint base = triangle * TRIANGLE_TEXELS;
    uvec4 x = fetch_triangle(base + walk.shear.texels.x);
    uvec4 y = fetch_triangle(base + walk.shear.texels.y);
    uvec4 z = fetch_triangle(base + walk.shear.texels.z);
    TriangleHit test =
        triangle_test(walk.shear, uintBitsToFloat(x.xyz), uintBitsToFloat(y.xyz), uintBitsToFloat(z.xyz));
    uint flags = walk.shear.texels.x == 0u ? x.w : walk.shear.texels.y == 0u ? y.w : z.w;
    bvh_accept(ray, walk, triangle, flags, test, any_hit);
    bvh_stop_if_hit(walk, any_hit);
}

// Leaves an instance that is done with, enters the next one. t means the same in all frames: an object's
// direction keeps the length that the transform gives it.
void bvh_instance_step(BvhRay ray, inout BvhWalk walk, const bool any_hit) {
    bool over = any_hit && walk.hit.triangle != NO_TRIANGLE;
    if (!bvh_going(walk) && walk.instance != BVH_NO_INSTANCE && !over) {
        bvh_enter_frame(walk, ray.origin, ray.direction, BVH_NO_INSTANCE);
        walk.cursor = walk.above;
        walk.floor = 0u;
        if (walk.depth > 0u) bvh_pop(walk);
    }
    if (walk.instance == BVH_NO_INSTANCE && bvh_has_leaves(walk)) {
        uint instance = bvh_take_leaf(walk);
        if (bvh_has_nodes(walk)) bvh_push(walk, walk.cursor.group);
        walk.above = walk.cursor;
        walk.above.group = 0u;
        walk.floor = walk.depth;
        uint base = instance * INSTANCE_TEXELS + 3u;
        vec4 x = uintBitsToFloat(fetch_instance(base));
        vec4 y = uintBitsToFloat(fetch_instance(base + 1u));
        vec4 z = uintBitsToFloat(fetch_instance(base + 2u));
        vec4 o = vec4(ray.origin, 1.0);
        bvh_enter_frame(walk, vec3(dot(x, o), dot(y, o), dot(z, o)),
                        vec3(dot(x.xyz, ray.direction), dot(y.xyz, ray.direction), dot(z.xyz, ray.direction)),
                        instance);
        walk.cursor = BvhCursor(bvh_root_group(bvh_root(instance), walk.box.key), 0u, 0u, 0u);
    }
}

#endif
