// What kernels write: path state, shadow rays, segment counters and path radiances (bindings.glsl.h).
// Paths and shadow rays are read and written as whole 16-byte words: on lavapipe every load or store is a
// loop over the lanes, and a store one over lanes and components.
#ifndef AJAR_PATHS_GLSL
#define AJAR_PATHS_GLSL
#include "../shared/bindings.glsl.h"
#include "../shared/path.glsl.h"
#include "tables.glsl"

layout(set = 0, binding = BIND_PATHS, std430) buffer PathsBlock { uvec4 path_words[]; };
layout(set = 0, binding = BIND_SHADOW_RAYS, std430) buffer ShadowRaysBlock { uvec4 shadow_ray_words[]; };
layout(set = 0, binding = BIND_SEGMENTS, scalar) buffer SegmentsBlock { SegmentCounts segments[]; };
layout(set = 0, binding = BIND_RADIANCE, std430) buffer RadianceBlock { vec4 radiance[]; };
layout(set = 0, binding = BIND_PATHS_READ) uniform usamplerBuffer path_texels;
layout(set = 0, binding = BIND_SHADOW_RAYS_READ) uniform usamplerBuffer shadow_ray_texels;
layout(set = 0, binding = BIND_RADIANCE_READ) uniform usamplerBuffer radiance_texels;

uvec4 path_word(uint i) {
    if (PATH_TEXELS != 0u) return texelFetch(path_texels, int(i));
    return path_words[i];
}

uvec4 shadow_ray_word(uint i) {
    if (PATH_TEXELS != 0u) return texelFetch(shadow_ray_texels, int(i));
    return shadow_ray_words[i];
}

// A path as extend left it. Without instancing all triangles are instance 0's, and the word is not written.
PathState path_load(uint slot) {
    uvec4 a = path_word(4u * slot);
    uvec4 b = path_word(4u * slot + 1u);
    uvec4 c = path_word(4u * slot + 2u);
    uvec4 d = path_word(4u * slot + 3u);
    return PathState(uintBitsToFloat(a.xyz), a.w, uintBitsToFloat(b.xyz), b.w, uintBitsToFloat(c.xyz),
                     uintBitsToFloat(c.w), d.x, has_feature(FEATURE_INSTANCES) ? d.y : 0u,
                     uintBitsToFloat(d.z), uintBitsToFloat(d.w));
}

// The triangle that a path met.
uint path_triangle(uint slot) { return path_word(4u * slot + 3u).x; }

// What extend finds.
void path_store_hit(uint slot, uint triangle, uint instance, float u, float v) {
    path_words[4u * slot + 3u].x = triangle;
    if (has_feature(FEATURE_INSTANCES)) path_words[4u * slot + 3u].y = instance;
    path_words[4u * slot + 3u].zw = floatBitsToUint(vec2(u, v));
}

// A path about to be extended.
void path_store(uint slot, PathState path) {
    path_words[4u * slot] = uvec4(floatBitsToUint(path.origin), path.home);
    path_words[4u * slot + 1u] = uvec4(floatBitsToUint(path.direction), path.leaves);
    path_words[4u * slot + 2u] = uvec4(floatBitsToUint(path.beta), floatBitsToUint(path.pdf));
    if (has_feature(FEATURE_INSTANCES)) path_words[4u * slot + 3u].y = path.instance;
}

ShadowRay shadow_ray_load(uint slot) {
    uvec4 a = shadow_ray_word(4u * slot);
    uvec4 b = shadow_ray_word(4u * slot + 1u);
    uvec4 c = shadow_ray_word(4u * slot + 2u);
    uint instance = 0u;
    if (has_feature(FEATURE_INSTANCES)) instance = shadow_ray_word(4u * slot + 3u).x;
    return ShadowRay(uintBitsToFloat(a.xyz), a.w, uintBitsToFloat(b.xyz), uintBitsToFloat(b.w),
                     uintBitsToFloat(c.xyz), c.w, instance, 0u, uint[2](0u, 0u));
}

void shadow_ray_store(uint slot, ShadowRay ray) {
    shadow_ray_words[4u * slot] = uvec4(floatBitsToUint(ray.origin), ray.leaves);
    shadow_ray_words[4u * slot + 1u] = uvec4(floatBitsToUint(ray.direction), floatBitsToUint(ray.reach));
    shadow_ray_words[4u * slot + 2u] = uvec4(floatBitsToUint(ray.contribution), ray.home);
    if (has_feature(FEATURE_INSTANCES)) shadow_ray_words[4u * slot + 3u].x = ray.instance;
}

// Apart from the rest: only a pass that learns has them.
void shadow_ray_counter_store(uint slot, uint counter) { shadow_ray_words[4u * slot + 3u].y = counter; }
uint shadow_ray_counter_load(uint slot) { return shadow_ray_word(4u * slot + 3u).y; }

vec3 radiance_load(uint home) {
    if (PATH_TEXELS != 0u) return uintBitsToFloat(texelFetch(radiance_texels, int(home)).xyz);
    return radiance[home].xyz;
}

void radiance_store(uint home, vec3 value) { radiance[home].xyz = value; }

// Behind all radiances lies what is kept of the surface that each path left last, which light samplers look
// at once more when the path meets a light (lights/receiver.glsl).
void path_left_store(uint home, uvec2 words) {
    radiance[frame.pool_paths + home].xy = uintBitsToFloat(words);
}
uvec2 path_left_load(uint home) {
    if (PATH_TEXELS != 0u) return texelFetch(radiance_texels, int(frame.pool_paths + home)).xy;
    return floatBitsToUint(radiance[frame.pool_paths + home].xy);
}

// Anything but zero at most once for a path in a dispatch: what was added there before need not be seen.
void radiance_add(uint home, vec3 value) { radiance_store(home, radiance_load(home) + value); }

#endif
