// The one accessor of read-only scene tables: texel buffers where the device's limits allow (on lavapipe two
// to four times faster), pointers elsewhere. Same values either way.
#ifndef AJAR_TABLES_GLSL
#define AJAR_TABLES_GLSL
#include "../shared/bindings.glsl.h"
#include "../shared/frame.glsl.h"
#include "variants.glsl"

layout(set = 0, binding = BIND_FRAME, scalar) uniform FrameBlock { FrameRecord frame; };
layout(set = 0, binding = BIND_NODES) uniform usamplerBuffer nodes_texels;
layout(set = 0, binding = BIND_TRIANGLES) uniform usamplerBuffer triangles_texels;
layout(set = 0, binding = BIND_SURFACES) uniform usamplerBuffer surfaces_texels;
layout(set = 0, binding = BIND_INSTANCES) uniform usamplerBuffer instances_texels;
layout(set = 0, binding = BIND_MATERIALS) uniform usamplerBuffer materials_texels;
layout(set = 0, binding = BIND_TEXELS) uniform samplerBuffer texels_texels;
layout(set = 0, binding = BIND_LIGHTS) uniform usamplerBuffer lights_texels;
layout(set = 0, binding = BIND_ENVIRONMENT) uniform usamplerBuffer environment_texels;
layout(set = 0, binding = BIND_VISIBILITY) uniform usamplerBuffer visibility_texels;
layout(set = 0, binding = BIND_PATCHES) uniform usamplerBuffer patches_texels;

uvec4 fetch_node(uint i) {
    if (TEXEL_BUFFERS != 0u) return texelFetch(nodes_texels, int(i));
    return frame.nodes.at[i].value;
}
uvec4 fetch_triangle(uint i) {
    if (TEXEL_BUFFERS != 0u) return texelFetch(triangles_texels, int(i));
    return frame.triangles.at[i].value;
}
uvec4 fetch_surface(uint i) {
    if (TEXEL_BUFFERS != 0u) return texelFetch(surfaces_texels, int(i));
    return frame.surfaces.at[i].value;
}
uvec4 fetch_instance(uint i) {
    if (TEXEL_BUFFERS != 0u) return texelFetch(instances_texels, int(i));
    return frame.instances.at[i].value;
}
uvec4 fetch_material(uint i) {
    if (TEXEL_BUFFERS != 0u) return texelFetch(materials_texels, int(i));
    return frame.materials.at[i].value;
}
vec4 fetch_texel(uint i) {
    if (TEXEL_BUFFERS != 0u) return texelFetch(texels_texels, int(i));
    // Not unpackUnorm4x8, which divides by 255: lavapipe converts texel buffers by a product, and both ways
    // must give the same bits. precise: else the compiler merges the factor with one that follows.
    const uint word = frame.texels.at[i].rgba8;
    precise vec4 texel = vec4(ivec4(uvec4(word, word >> 8, word >> 16, word >> 24) & 255u)) * (1.0 / 255.0);
    return texel;
}
uvec4 fetch_light(uint i) {
    if (TEXEL_BUFFERS != 0u) return texelFetch(lights_texels, int(i));
    return frame.lights.at[i].value;
}
uvec4 fetch_environment(uint i) {
    if (TEXEL_BUFFERS != 0u) return texelFetch(environment_texels, int(i));
    return frame.environment.at[i].value;
}
uvec4 fetch_patch(uint i) {
    if (TEXEL_BUFFERS != 0u) return texelFetch(patches_texels, int(i));
    return frame.patches.at[i].value;
}

#endif
