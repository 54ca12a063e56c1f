// What kernels write: path state, shadow rays, segment counters and path radiances (bindings.glsl.h).
// Paths and shadow rays are read and written as whole 16-byte words: on lavapipe every load or store is a
// loop over the lanes, and a store one over lanes and components.
#ifndef AJAR_PATHS_GLSL
#define AJAR_PATHS_GLSL
#include "../shared/bindings.glsl.h"
#include "../shared/path.glsl.h"
#include "variants.glsl"

layout(set = 0, binding = BIND_PATHS, std430) buffer PathsBlock { uvec4 path_words[]; };
layout(set = 0, binding = BIND_SHADOW_RAYS, std430) buffer ShadowRaysBlock { uvec4 shadow_ray_words[]; };
layout(set = 0, binding = BIND_SEGMENTS, scalar) buffer SegmentsBlock { SegmentCounts segments[]; };
layout(set = 0, binding = BIND_RADIANCE, std430) buffer RadianceBlock { vec4 radiance[]; };
layout(set = 0, binding = BIND_PATHS_READ) uniform usamplerBuffer path_texels;
layout(set = 0, binding = BIND_SHADOW_RAYS_READ) uniform usamplerBuffer shadow_ray_texels;

uvec4 path_word(uint i) {
    if (PATH_TEXELS != 0u) return texelFetch(path_texels, int(i));
    return path_words[i];
}

uvec4 shadow_ray_word(uint i) {
    if (PATH_TEXELS != 0u) return texelFetch(shadow_ray_texels, int(i));
    return shadow_ray_words[i];
}

PathState path_load(uint slot) {
    uvec4 a = path_word(4u * slot);
    uvec4 b = path_word(4u * slot + 1u);
    uvec4 c = path_word(4u * slot + 2u);
    uvec4 d = path_word(4u * slot + 3u);
    return PathState(uintBitsToFloat(a.xyz), a.w, uintBitsToFloat(b.xyz), uintBitsToFloat(b.w),
        uintBitsToFloat(c.xyz),
                     c.w, d.x, d.y, uintBitsToFloat(d.z), uintBitsToFloat(d.w));
}

// The last word alone: what extend finds. Without instancing all triangles are instance 0's.
void path_store_hit(uint slot, uint triangle, uint instance, float u, float v) {
    path_words[4u * slot + 3u] = uvec4(triangle, instance, floatBitsToUint(u), floatBitsToUint(v));
}

// A path about to be extended: u and v are left as they are, and what no kernel of this scene reads.
void path_store(uint slot, PathState path) {
    path_words[4u * slot] = uvec4(floatBitsToUint(path.origin), path.home);
    path_words[4u * slot + 1u] = uvec4(floatBitsToUint(path.direction), floatBitsToUint(path.pdf));
    path_words[4u * slot + 2u].xyz = floatBitsToUint(path.beta);
    if (has_feature(FEATURE_ALPHA)) path_words[4u * slot + 2u].w = path.salt;
    path_words[4u * slot + 3u].x = path.triangle;
    if (has_feature(FEATURE_INSTANCES)) path_words[4u * slot + 3u].y = path.instance;
}

ShadowRay shadow_ray_load(uint slot) {
    uvec4 a = shadow_ray_word(4u * slot);
    uvec4 b = shadow_ray_word(4u * slot + 1u);
    uvec4 c = shadow_ray_word(4u * slot + 2u);
    uvec4 d = shadow_ray_word(4u * slot + 3u);
    return ShadowRay(uintBitsToFloat(a.xyz), a.w, uintBitsToFloat(b.xyz), uintBitsToFloat(b.w),
        uintBitsToFloat(c.xyz),
                     c.w, d.x, d.y, d.z, d.w);
}

void shadow_ray_store(uint slot, ShadowRay ray) {
    shadow_ray_words[4u * slot] = uvec4(floatBitsToUint(ray.origin), ray.home);
    shadow_ray_words[4u * slot + 1u] = uvec4(floatBitsToUint(ray.direction), floatBitsToUint(ray.distance));
    shadow_ray_words[4u * slot + 2u] = uvec4(floatBitsToUint(ray.contribution), ray.triangle);
    shadow_ray_words[4u * slot + 3u].y = ray.light_triangle;
    if (has_feature(FEATURE_INSTANCES)) shadow_ray_words[4u * slot + 3u].x = ray.instance;
    if (has_feature(FEATURE_INSTANCES)) shadow_ray_words[4u * slot + 3u].z = ray.light_instance;
    if (has_feature(FEATURE_ALPHA)) shadow_ray_words[4u * slot + 3u].w = ray.salt;
}

void radiance_add(uint home, vec3 value) { radiance[home] = radiance[home] + vec4(value, 0.0); }

#endif
