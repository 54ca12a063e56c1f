// Cells of surface points and what they learned about the light tree's nodes (light_visibility.glsl.h). A
// cell holds points near each other, as near as they are far from the camera (Binder et al. 2019, "Massively
// Parallel Path Space Filtering"), that face the same way.
#ifndef AJAR_LIGHT_VISIBILITY_GLSL
#define AJAR_LIGHT_VISIBILITY_GLSL
#include "../core/rng.glsl"
#include "../core/tables.glsl"
#include "../shared/light_tree.glsl.h"
#include "../shared/light_visibility.glsl.h"

// A cell's side in units of the distance from the camera; up to twice that, sides being powers of two.
const float VISIBILITY_CELL_SIZE = 1.0 / 10.0;
// Flat surfaces lie at round coordinates: there no cell ends.
const float VISIBILITY_CELL_OFFSET = 0.381966;

const bool LIGHT_SAMPLER_LEARNS = LIGHT_SAMPLER == LIGHT_SAMPLER_VISIBILITY;

// Which of six directions a normal is nearest to.
uint visibility_side(vec3 n) {
    const vec3 a = abs(n);
    const uint axis = a.x > a.y && a.x > a.z ? 0u : (a.y > a.z ? 1u : 2u);
    const float along = axis == 0u ? n.x : (axis == 1u ? n.y : n.z);
    return 2u * axis + (along < 0.0 ? 1u : 0u);
}

uint visibility_cell(vec3 point, vec3 normal) {
    const float distance = max(length(point - frame.camera_origin), 1e-3 * frame.scene_radius);
    const float level = ceil(log2(distance * VISIBILITY_CELL_SIZE));
    const ivec3 at = ivec3(floor(clamp(point * exp2(-level) + VISIBILITY_CELL_OFFSET, -1e9, 1e9)));
    uint key = rng_combine(uint(int(level)) * 8u + visibility_side(normal), uint(at.x));
    key = rng_combine(rng_combine(key, uint(at.y)), uint(at.z));
    return key & (VISIBILITY_CELLS - 1u);
}

uvec4 visibility_texel(uint i) {
    if (TEXEL_BUFFERS != 0u) return texelFetch(visibility_texels, int(i));
    return frame.visibility.at[i].value;
}

vec4 visibility_of_bytes(uint four) {
    return vec4(ivec4(uvec4(four, four >> 8, four >> 16, four >> 24) & 255u) + 1) * (1.0 / 256.0);
}

// Of the four children of node k; 1 below the levels that are learned about.
vec4 visibility_of_children(uint cell, uint k) {
    const bool known = k < VISIBILITY_CLUSTERS / 2u;
    const uint word = known ? k : 0u;
    const uvec4 four = visibility_texel(cell * VISIBILITY_CELL_TEXELS + (word >> 2));
    const uvec2 two = (word & 2u) != 0u ? four.zw : four.xy;
    const vec4 seen = visibility_of_bytes((word & 1u) != 0u ? two.y : two.x);
    return known ? seen : vec4(1.0);
}

// Of the distant lights (x) and of all others (y).
vec2 visibility_of_all(uint cell) {
    return visibility_of_bytes(visibility_texel(cell * VISIBILITY_CELL_TEXELS).x).xy;
}

// The counter of a shadow ray from the cell to a light with that trail (NO_TRAIL: a distant one).
uint visibility_counter(uint cell, uint trail) {
    const uint way = trail >> (LIGHT_TREE_TRAIL_TOP - 2u * VISIBILITY_LEVELS);
    return cell * VISIBILITY_COUNTERS + (trail == NO_TRAIL ? VISIBILITY_CLUSTERS : way);
}

#endif
