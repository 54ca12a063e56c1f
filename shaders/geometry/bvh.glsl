// Closest hit and any hit of one ray per thread: the portable traversal. Every loop is bounded: lavapipe
// (Mesa 22.3) ends all loops of an invocation after 65,535 iterations, silently; rays that run out here are
// counted.
#ifndef AJAR_BVH_GLSL
#define AJAR_BVH_GLSL
#include "alpha.glsl"
#include "bvh_node.glsl"
#include "leave.glsl"
#include "triangle.glsl"

struct Hit {
    float t;       // of the ray as given, metres; the limit where there is no hit
    uint triangle; // NO_TRIANGLE: none
    uint instance;
    float u;
    float v;
    bool exhausted; // the answer may be wrong: the iteration bound was reached
};

struct BvhRay {
    vec3 origin;
    vec3 direction;
    float limit;            // hits at or beyond it do not count
    uint triangle;          // never hit: the triangle the ray leaves
    uint instance;
    uint target_triangle;   // never hit: the one it aims at
    uint target_instance;
    uint salt;
};

// Iterations per ray that keep all rays of an invocation below the driver's limit, setup loops included.
uint bvh_step_limit() { return clamp(60000u * WORKGROUP_SIZE / SEGMENT_SIZE, 64u, 16384u); }

// What a traversal has still to do.
struct BvhCursor {
    uint child_base;
    uint pending;       // inner hits in order of the octant | inner slots << 8
    uint triangle_base;
    uint leaves;
    uint leaf_hits;
};

const float BVH_FAR = 3.0e38; // finite, so that a limit times a margin is

#define BVH_STACK (2u * BVH_MAX_DEPTH + 1u)
const uint BVH_NO_INSTANCE = 0xffffffffu; // in the hierarchy over instances

// The frame in which the ray is at the moment.
struct BvhFrame {
    BoxRay box;
    TriangleRay shear;
    uint instance;
    uint floor;    // stack entries below it belong to the hierarchy over instances
};

BvhFrame bvh_frame(vec3 origin, vec3 direction, uint instance, uint floor) {
    return BvhFrame(box_ray(origin, direction), triangle_ray(origin, direction), instance, floor);
}

// The direction keeps its length's meaning: t is the same in both frames.
BvhFrame bvh_instance_frame(BvhRay ray, uint instance, uint floor) {
    uint base = instance * INSTANCE_TEXELS + 3u;
    vec4 x = uintBitsToFloat(fetch_instance(base));
    vec4 y = uintBitsToFloat(fetch_instance(base + 1u));
    vec4 z = uintBitsToFloat(fetch_instance(base + 2u));
    vec4 o = vec4(ray.origin, 1.0);
    return bvh_frame(vec3(dot(x, o), dot(y, o), dot(z, o)),
                     vec3(dot(x.xyz, ray.direction), dot(y.xyz, ray.direction), dot(z.xyz, ray.direction)),
                         instance, floor);
}

uint bvh_root(uint instance) { return fetch_instance(instance * INSTANCE_TEXELS + 6u).x; }

// The group that holds nothing but a root.
uint bvh_root_pending(uint octant) { return 1u << octant | 0x100u; }

// Tries the lowest pending triangle. Equal distances go to the lower triangle, so no order of traversal
// shows.
void bvh_triangle(BvhRay ray, BvhFrame here, inout BvhCursor cursor, inout Hit hit) {
    uint instance = here.instance;
    uint bit = uint(findLSB(cursor.leaf_hits));
    uint triangle = cursor.triangle_base + uint(bitCount(cursor.leaves & ((1u << bit) - 1u)));
    cursor.leaf_hits &= cursor.leaf_hits - 1u;
    uint base = triangle * TRIANGLE_TEXELS;
    uvec4 a = fetch_triangle(base);
    TriangleHit test = triangle_test(here.shear, uintBitsToFloat(a.xyz),
        uintBitsToFloat(fetch_triangle(base + 1u).xyz),
                                     uintBitsToFloat(fetch_triangle(base + 2u).xyz));
    bool same_instance = !has_feature(FEATURE_INSTANCES) || instance == ray.instance;
    bool same_target = !has_feature(FEATURE_INSTANCES) || instance == ray.target_instance;
    bool excluded = (triangle == ray.triangle && same_instance) || (triangle == ray.target_triangle &&
        same_target);
    bool lower = triangle < hit.triangle;
    if (has_feature(FEATURE_INSTANCES))
        lower = instance < hit.instance || (instance == hit.instance && lower);
    bool closer = test.t < hit.t || (test.t == hit.t && hit.triangle != NO_TRIANGLE && lower);
    bool found = test.inside && closer && !excluded;
    if (has_feature(FEATURE_ALPHA)) {
        if (found && (a.w & TRIANGLE_ALPHA) != 0u) {
            bool flipped = has_feature(FEATURE_INSTANCES) &&
                           (fetch_instance(instance * INSTANCE_TEXELS + 6u).y & INSTANCE_FLIPPED) != 0u;
            found = alpha_passes(triangle, instance, test.u, test.v, test.back_face != flipped, ray.salt);
        }
    }
    hit.t = found ? test.t : hit.t;
    hit.triangle = found ? triangle : hit.triangle;
    hit.instance = found ? instance : hit.instance;
    hit.u = found ? test.u : hit.u;
    hit.v = found ? test.v : hit.v;
}

Hit bvh_trace(BvhRay ray, const bool any_hit) {
    const bool two_levels = has_feature(FEATURE_INSTANCES);
    uint stack_base[BVH_STACK];
    uint stack_pending[BVH_STACK];
    uint depth = 0u;
    BvhFrame here = bvh_frame(ray.origin, ray.direction, 0u, 0u);
    BvhCursor cursor = BvhCursor(frame.root, bvh_root_pending(here.box.octant), 0u, 0u, 0u);
    // The leaf in the hierarchy over instances from which the ray came into this instance
    BvhCursor above = cursor;
    if (two_levels) {
        // The world first; below it waits the hierarchy over instances.
        stack_base[0] = cursor.child_base;
        stack_pending[0] = cursor.pending;
        depth = 1u;
        here.floor = 1u;
        cursor.child_base = bvh_root(0u);
    }
    Hit hit = Hit(ray.limit, NO_TRIANGLE, 0u, 0.0, 0.0, false);
    uint steps = 0u;
    const uint limit = bvh_step_limit();
    bool going = true;
    while (going && steps < limit) {
        while ((cursor.pending & 0xffu) != 0u && cursor.leaf_hits == 0u && steps < limit) {
            ++steps;
            uint order = uint(findLSB(cursor.pending));
            uint slot = order ^ here.box.octant;
            uint inner = cursor.pending >> 8;
            uint node = cursor.child_base + uint(bitCount(inner & ((1u << slot) - 1u)));
            uint rest = cursor.pending & ~(1u << order);
            if ((rest & 0xffu) != 0u) {
                stack_base[depth] = cursor.child_base;
                stack_pending[depth] = rest;
                ++depth;
            }
            NodeHits hits = box_node(node, here.box, box_min(hit.t, BVH_FAR) * BOX_FAR);
            cursor = BvhCursor(hits.child_base, hits.inner_hits | hits.inner << 8, hits.triangle_base,
                hits.leaves,
                               hits.leaf_hits);
            if (hits.inner_hits == 0u && depth > here.floor) {
                --depth;
                cursor.child_base = stack_base[depth];
                cursor.pending = stack_pending[depth];
            }
        }
        while (cursor.leaf_hits != 0u && here.instance != BVH_NO_INSTANCE && steps < limit) {
            ++steps;
            bvh_triangle(ray, here, cursor, hit);
            if (any_hit && hit.triangle != NO_TRIANGLE) cursor.leaf_hits = 0u;
        }
        if (two_levels) {
            ++steps;
            bool finished = (cursor.pending & 0xffu) == 0u && cursor.leaf_hits == 0u;
            if (finished && here.instance != BVH_NO_INSTANCE) { // back to the hierarchy over instances
                here = bvh_frame(ray.origin, ray.direction, BVH_NO_INSTANCE, 0u);
                cursor = above;
                if (depth > 0u) {
                    --depth;
                    cursor.child_base = stack_base[depth];
                    cursor.pending = stack_pending[depth];
                }
            }
            if (here.instance == BVH_NO_INSTANCE && cursor.leaf_hits != 0u) { // into an instance
                uint bit = uint(findLSB(cursor.leaf_hits));
                uint instance = cursor.triangle_base + uint(bitCount(cursor.leaves & ((1u << bit) - 1u)));
                cursor.leaf_hits &= cursor.leaf_hits - 1u;
                if ((cursor.pending & 0xffu) != 0u) {
                    stack_base[depth] = cursor.child_base;
                    stack_pending[depth] = cursor.pending;
                    ++depth;
                }
                above = cursor;
                above.pending = 0u;
                here = bvh_instance_frame(ray, instance, depth);
                cursor = BvhCursor(bvh_root(instance), bvh_root_pending(here.box.octant), 0u, 0u, 0u);
            }
        }
        going = (cursor.pending & 0xffu) != 0u || cursor.leaf_hits != 0u;
        if (any_hit) going = going && hit.triangle == NO_TRIANGLE;
    }
    hit.exhausted = going;
    return hit;
}

#endif
