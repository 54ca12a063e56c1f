// One wide node against one ray: which slots does the ray meet, and what is in them. See shared/bvh.glsl.h.
// The slab test is conservative (Ize 2013, "Robust BVH Ray Traversal"): node boxes carry a margin for
// rounding in proportion to their size, BoxRay's far planes one in proportion to distance.
#ifndef AJAR_BVH_NODE_GLSL
#define AJAR_BVH_NODE_GLSL
#include "../core/tables.glsl"
#include "../shared/bvh.glsl.h"

struct BoxRay {
    vec3 origin;
    vec3 inverse;  // 1 / direction; finite
    uint octant;   // bit a: direction[a] < 0
};

// Below this a component counts as this: its reciprocal times a coordinate (up to 1e20) and a step must not
// overflow.
const float BOX_MIN_DIRECTION = 8.8817842e-16; // 2^-50
// A few roundings at 2^-24 each, with room for inexact reciprocals
const float BOX_FAR = 1.0 + 1.0 / 1048576.0;

float box_inverse(float d) {
    return 1.0 / (abs(d) < BOX_MIN_DIRECTION ? (floatBitsToInt(d) < 0 ? -BOX_MIN_DIRECTION :
        BOX_MIN_DIRECTION) : d);
}

BoxRay box_ray(vec3 origin, vec3 direction) {
    BoxRay ray;
    ray.origin = origin;
    ray.inverse = vec3(box_inverse(direction.x), box_inverse(direction.y), box_inverse(direction.z));
    ray.octant = (ray.inverse.x < 0.0 ? 1u : 0u) | (ray.inverse.y < 0.0 ? 2u : 0u) | (ray.inverse.z < 0.0 ?
        4u : 0u);
    return ray;
}

// Swaps bits of the slots of a mask: slot s becomes bit s ^ octant, so the lowest bit is (roughly) the
// nearest slot.
uint box_to_order(uint mask, uint octant) {
    mask = (octant & 1u) != 0u ? (mask & 0x55u) << 1 | (mask >> 1 & 0x55u) : mask;
    mask = (octant & 2u) != 0u ? (mask & 0x33u) << 2 | (mask >> 2 & 0x33u) : mask;
    mask = (octant & 4u) != 0u ? (mask & 0x0fu) << 4 | (mask >> 4 & 0x0fu) : mask;
    return mask;
}

struct NodeHits {
    uint child_base;
    uint inner;         // slots with an inner child
    uint inner_hits;    // of those the ones met, in the order of box_to_order
    uint triangle_base;
    uint leaves;        // as in BvhNode
    uint leaf_hits;     // triangles of the leaves met, bits as in `leaves`
};

float box_min(float a, float b) { return a < b ? a : b; }
float box_max(float a, float b) { return a > b ? a : b; }

float box_byte(uint word, uint index) { return float(int(word >> (8u * index) & 0xffu)); }

// Four slots: bits of those the ray meets before `limit`.
uint box_four(uint nx, uint ny, uint nz, uint fx, uint fy, uint fz, vec3 scale, vec3 offset, vec3 far_scale,
              vec3 far_offset, float limit) {
    uint hits = 0u;
    for (uint i = 0u; i < 4u; ++i) {
        float x0 = box_byte(nx, i) * scale.x + offset.x;
        float y0 = box_byte(ny, i) * scale.y + offset.y;
        float z0 = box_byte(nz, i) * scale.z + offset.z;
        float x1 = box_byte(fx, i) * far_scale.x + far_offset.x;
        float y1 = box_byte(fy, i) * far_scale.y + far_offset.y;
        float z1 = box_byte(fz, i) * far_scale.z + far_offset.z;
        float near = box_max(box_max(x0, y0), box_max(z0, 0.0));
        float far = box_min(box_min(x1, y1), box_min(z1, limit));
        hits |= near <= far ? 1u << i : 0u;
    }
    return hits;
}

// `limit`: the ray's end so far, already times BOX_FAR.
NodeHits box_node(uint node, BoxRay ray, float limit) {
    uint base = node * BVH_NODE_TEXELS;
    uvec4 head = fetch_node(base);
    uvec4 links = fetch_node(base + 1u);
    uvec4 q0 = fetch_node(base + 2u); // lower x, x, y, y
    uvec4 q1 = fetch_node(base + 3u); // lower z, z, upper x, x
    uvec4 q2 = fetch_node(base + 4u); // upper y, y, z, z
    vec3 scale = ray.inverse * uintBitsToFloat(uvec3(head.w << 23, (head.w & 0xff00u) << 15, (head.w &
        0xff0000u) << 7) &
                                               0x7f800000u);
    vec3 offset = (uintBitsToFloat(head.xyz) - ray.origin) * ray.inverse;
    bvec3 negative = lessThan(ray.inverse, vec3(0.0));
    uvec2 nx = negative.x ? q1.zw : q0.xy;
    uvec2 fx = negative.x ? q0.xy : q1.zw;
    uvec2 ny = negative.y ? q2.xy : q0.zw;
    uvec2 fy = negative.y ? q0.zw : q2.xy;
    uvec2 nz = negative.z ? q2.zw : q1.xy;
    uvec2 fz = negative.z ? q1.xy : q2.zw;
    vec3 far_scale = scale * BOX_FAR;
    vec3 far_offset = offset * BOX_FAR;
    uint hits = box_four(nx.x, ny.x, nz.x, fx.x, fy.x, fz.x, scale, offset, far_scale, far_offset, limit) |
                box_four(nx.y, ny.y, nz.y, fx.y, fy.y, fz.y, scale, offset, far_scale, far_offset,
                    limit) << 4;
    NodeHits node_hits;
    node_hits.child_base = links.x;
    node_hits.inner = head.w >> 24;
    node_hits.inner_hits = box_to_order(hits & node_hits.inner, ray.octant);
    node_hits.triangle_base = links.y;
    node_hits.leaves = links.z;
    node_hits.leaf_hits = (hits | hits << 8 | hits << 16) & links.z;
    return node_hits;
}

#endif
