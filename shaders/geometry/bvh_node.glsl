// One wide node against one ray: which slots does the ray meet, and what is in them. See shared/bvh.glsl.h.
// The slab test is conservative (Ize 2013, "Robust BVH Ray Traversal"): node boxes carry a margin for
// rounding in proportion to their size, BoxRay's far planes one in proportion to distance.
#ifndef AJAR_BVH_NODE_GLSL
#define AJAR_BVH_NODE_GLSL
#include "../core/tables.glsl"
#include "../shared/bvh.glsl.h"

// Below this a component counts as this: its reciprocal times a coordinate (up to 1e20) and a step must not
// overflow.
const float BOX_MIN_DIRECTION = 8.8817842e-16; // 2^-50
const float BOX_FAR =
    1.0 + 1.0 / 1048576.0;       // a few roundings at 2^-24 each, with room for inexact reciprocals
const float BOX_NEAR = -1.0e-30; // behind the origin only by name

struct BoxRay {
    vec3 origin;
    vec3 inverse;    // 1 / direction; finite
    uint key;        // slot s is visited in the order of s ^ key, the highest first
    uint key_shift;  // 8 * (key & 3): the byte of BvhNode::inner_orders
    uint half_shift; // key & 4: swaps that byte's halves
    uint bits[8];    // of slot s: 1 << (s ^ key) | 0x700 << 3 s
};

float box_inverse(float d) {
    return 1.0 / (abs(d) < BOX_MIN_DIRECTION
                      ? (floatBitsToInt(d) < 0 ? -BOX_MIN_DIRECTION : BOX_MIN_DIRECTION)
                      : d);
}

void box_set_key(inout BoxRay ray, uint key) {
    ray.key = key;
    ray.key_shift = (key & 3u) << 3;
    ray.half_shift = key & 4u;
    for (uint s = 0u; s < 8u; ++s) ray.bits[s] = 1u << (s ^ key) | 0x700u << 3u * s;
}

BoxRay box_ray(vec3 origin, vec3 direction) {
    BoxRay ray;
    ray.origin = origin;
    ray.inverse = vec3(box_inverse(direction.x), box_inverse(direction.y), box_inverse(direction.z));
    box_set_key(ray, (ray.inverse.x < 0.0 ? 0u : 1u) | (ray.inverse.y < 0.0 ? 0u : 2u) |
                         (ray.inverse.z < 0.0 ? 0u : 4u));
    return ray;
}

struct NodeHits {
    uint group; // child_base of BvhNode | inner children met, slot s at bit s ^ key
    uint triangle_base;
    uint leaves;    // as in BvhNode
    uint leaf_hits; // triangles of the leaves met, bits as in `leaves`
};

float box_min(float a, float b) { return a < b ? a : b; }
float box_max(float a, float b) { return a > b ? a : b; }

// 1 + q / 256 for byte q of a word, made of bits: one operation less than a conversion.
float box_byte(uint word, uint index) {
    uint bits = index < 2u ? word << (15u - 8u * index) : word >> (8u * index - 15u);
    return uintBitsToFloat(bits & 0x7f8000u | 0x3f800000u);
}

// One slot's bits where the ray meets its box before `limit`, else 0.
uint box_slot(uint bits, uint index, uint nx, uint ny, uint nz, uint fx, uint fy, uint fz, vec3 scale,
              vec3 offset, vec3 far_scale, vec3 far_offset, float limit) {
    float x0 = box_byte(nx, index) * scale.x + offset.x;
    float y0 = box_byte(ny, index) * scale.y + offset.y;
    float z0 = box_byte(nz, index) * scale.z + offset.z;
    float x1 = box_byte(fx, index) * far_scale.x + far_offset.x;
    float y1 = box_byte(fy, index) * far_scale.y + far_offset.y;
    float z1 = box_byte(fz, index) * far_scale.z + far_offset.z;
    float near = box_max(box_max(x0, y0), z0);
    float far = box_min(box_min(x1, y1), box_min(z1, limit));
    return near <= far && far >= BOX_NEAR ? bits : 0u;
}

// The steps of a node's grid.
vec3 box_steps(uint exponents) {
    return uintBitsToFloat(uvec3(exponents << 23, exponents << 15, exponents << 7) & 0x7f800000u);
}

// From the bits of the slots met and the second texel of the node.
NodeHits box_hits(uint hits, uvec4 links, BoxRay ray) {
    uint inner = links.y >> ray.key_shift & 0xffu;
    inner = (inner | inner << 8) >> ray.half_shift & 0xffu;
    return NodeHits(links.x | (hits & inner), links.z, links.w, hits >> 8 & links.w);
}

// `limit`: the ray's end so far, already times BOX_FAR.
NodeHits box_node(uint node, BoxRay ray, float limit) {
    uint base = node * BVH_NODE_TEXELS;
    uvec4 head = fetch_node(base);
    uvec4 links = fetch_node(base + 1u);
    uvec4 q0 = fetch_node(base + 2u); // lower x, x, y, y
    uvec4 q1 = fetch_node(base + 3u); // lower z, z, upper x, x
    uvec4 q2 = fetch_node(base + 4u); // upper y, y, z, z
    vec3 scale = ray.inverse * (256.0 * box_steps(head.w));
    vec3 offset = (uintBitsToFloat(head.xyz) - ray.origin) * ray.inverse - scale; // box_byte begins at 1
    bool negative_x = ray.inverse.x < 0.0;
    bool negative_y = ray.inverse.y < 0.0;
    bool negative_z = ray.inverse.z < 0.0;
    uvec2 nx = negative_x ? q1.zw : q0.xy;
    uvec2 fx = negative_x ? q0.xy : q1.zw;
    uvec2 ny = negative_y ? q2.xy : q0.zw;
    uvec2 fy = negative_y ? q0.zw : q2.xy;
    uvec2 nz = negative_z ? q2.zw : q1.xy;
    uvec2 fz = negative_z ? q1.xy : q2.zw;
    vec3 far_scale = scale * BOX_FAR;
    vec3 far_offset = offset * BOX_FAR;
    uint hits = 0u;
    for (uint i = 0u; i < 4u; ++i)
        hits |= box_slot(ray.bits[i], i, nx.x, ny.x, nz.x, fx.x, fy.x, fz.x, scale, offset, far_scale,
                         far_offset, limit);
    for (uint i = 0u; i < 4u; ++i)
        hits |= box_slot(ray.bits[4u + i], i, nx.y, ny.y, nz.y, fx.y, fy.y, fz.y, scale, offset, far_scale,
                         far_offset, limit);
    return box_hits(hits, links, ray);
}

#endif
