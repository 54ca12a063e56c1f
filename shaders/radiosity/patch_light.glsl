// What radiosity found for a patch's side (PatchSide in shared/patch.glsl.h).
#ifndef AJAR_PATCH_LIGHT_GLSL
#define AJAR_PATCH_LIGHT_GLSL
#include "patch_lookup.glsl"

// Constant over the patch, W/(m^2 sr).
vec3 patch_radiance(uint side) {
    return uintBitsToFloat(fetch_patch(frame.patch_sides_first + PATCH_SIDE_TEXELS * side).xyz);
}

// W/m^2 at barycentrics (u, v) of the patch.
vec3 patch_irradiance(uint side, float u, float v) {
    const uint first = frame.patch_sides_first + PATCH_SIDE_TEXELS * side;
    const vec4 a = uintBitsToFloat(fetch_patch(first));
    const vec4 b = uintBitsToFloat(fetch_patch(first + 1u));
    const vec4 c = uintBitsToFloat(fetch_patch(first + 2u));
    return (1.0 - u - v) * vec3(a.w, b.xy) + u * vec3(b.zw, c.x) + v * c.yzw;
}

#endif
