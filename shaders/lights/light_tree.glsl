// The light tree: how much the lights below a node may bring to a point, and the way down to one of them by a
// single random number (Conty Estevez and Kulla 2018; bounds of cosines over a cone as in Pharr et al. 2023,
// section 12.6.3, with spheres for boxes). Importance is what would arrive from the node's sphere at best,
// so a light that can light the point is never out of reach.
#ifndef AJAR_LIGHT_TREE_GLSL
#define AJAR_LIGHT_TREE_GLSL
#include "../core/math.glsl"
#include "../core/octahedral.glsl"
#include "../core/rng.glsl"
#include "../shared/light_tree.glsl.h"
#include "light_pick.glsl"
#include "light_visibility.glsl"

// Cosines below this count as this: light that just grazes is still light, and float cosines of bounds err.
const float LIGHT_TREE_GRAZING = 2e-3;
const float LIGHT_TREE_LEAST = 9.5367431640625e-7; // 2^-20: least share of a decision that is not none

// cos(max(0, a - b)) from the sines and cosines of two angles in [0, pi].
float light_tree_cos_within(float cos_a, float sin_a, float cos_b, float sin_b) {
    return cos_a > cos_b ? 1.0 : cos_a * cos_b + sin_a * sin_b;
}

// Irradiance (luminance, W/m^2) that the node's lights may bring to a surface at `point` with unit normal
// `normal`: intensity cos cos' / d^2, the cosines at their best over the node's sphere. 0 where none can. `a`
// and `b`: the node's two texels.
float light_tree_importance(vec3 point, vec3 normal, uvec4 a, uvec4 b) {
    const vec3 to_center = uintBitsToFloat(a.xyz) - point;
    const float radius = uintBitsToFloat(a.w);
    const float radius2 = radius * radius;
    const float distance2 = max(dot(to_center, to_center), 1e-36);
    const vec3 w = to_center * inversesqrt(distance2);
    const bool inside = distance2 <= radius2;
    // Half angle of the sphere as seen from the point.
    const float sin2_sphere = radius2 / distance2;
    const float cos_sphere = math_safe_sqrt(1.0 - sin2_sphere);
    const float sin_sphere = sqrt(min(sin2_sphere, 1.0));

    const float cos_normals = float(int(b.y << 16) >> 16) * (1.0 / 32767.0);
    const float cos_emission = float(int(b.y) >> 16) * (1.0 / 32767.0);
    const float along = -dot(octahedral_decode(b.x), w);
    const float cos_axis = (b.w & LIGHT_TREE_TWO_SIDED) != 0u ? abs(along) : along;
    const float sin_axis = math_safe_sqrt(1.0 - cos_axis * cos_axis);
    const float sin_normals = math_safe_sqrt(1.0 - cos_normals * cos_normals);
    // Angle between the nearest normal and the way to the point's side of the sphere.
    const float cos_nearest = light_tree_cos_within(cos_axis, sin_axis, cos_normals, sin_normals);
    const float sin_nearest = math_safe_sqrt(1.0 - cos_nearest * cos_nearest);
    const float leaving = light_tree_cos_within(cos_nearest, sin_nearest, cos_sphere, sin_sphere);

    const float cos_center = dot(normal, w);
    const float sin_center = math_safe_sqrt(1.0 - cos_center * cos_center);
    const float arriving = light_tree_cos_within(cos_center, sin_center, cos_sphere, sin_sphere);

    const bool reachable = leaving > cos_emission - LIGHT_TREE_GRAZING && arriving > -LIGHT_TREE_GRAZING;
    const float cosines = max(leaving, LIGHT_TREE_GRAZING) * max(arriving, LIGHT_TREE_GRAZING);
    const float intensity = uintBitsToFloat(b.z) / max(distance2, radius2);
    return inside ? intensity : (reachable ? intensity * cosines : 0.0);
}

struct LightTreeWay {
    float pmf;  // product of the decisions' probabilities
    float u;    // what is left of u
    float step; // of its digits
    uint light;
};

// Down to a light: by u, or, to learn how probable a light is, along its trail. Both take the same decisions'
// probabilities, to the last bit. What `cell` learned of a node's visibility scales its importance.
LightTreeWay light_tree_descend(vec3 point, vec3 normal, uint cell, float u, uint trail, bool follow) {
    LightTreeWay way = LightTreeWay(1.0, u, LIGHT_PICK_STEP, 0u);
    // u has 24 digits, and every decision uses some up: more are drawn from a hash of the point, which leaves
    // a long way's probabilities exact on average over points, where 2^24 values of u could not.
    uint digits = rng_combine(floatBitsToUint(u), floatBitsToUint(point.x) ^ floatBitsToUint(point.z));
    uint child = fetch_light(frame.tree_first + 1u).w;
    uint node = 1u; // as in a heap; runs over below the levels that are learned about
    for (uint depth = 0u; depth < LIGHT_TREE_MAX_DEPTH && (child & LIGHT_TREE_LEAF) == 0u; ++depth) {
        const uint pair = frame.tree_first + LIGHT_TREE_PAIR_TEXELS * (child & LIGHT_TREE_INDEX);
        const uvec4 left_b = fetch_light(pair + 1u);
        const uvec4 right_b = fetch_light(pair + 3u);
        float left = light_tree_importance(point, normal, fetch_light(pair), left_b);
        float right = light_tree_importance(point, normal, fetch_light(pair + 2u), right_b);
        if (LIGHT_SAMPLER_LEARNS) {
            const vec2 seen = visibility_of_pair(cell, node);
            left *= seen.x;
            right *= seen.y;
        }
        const float sum = left + right;
        // Where neither can bring anything any light will do: probabilities still sum to 1.
        // A side that can bring anything keeps a share that 24 digits can tell from none.
        const float least = left > 0.0 ? LIGHT_TREE_LEAST : 0.0;
        const float most = right > 0.0 ? 1.0 - LIGHT_TREE_LEAST : 1.0;
        const float share = left / sum;
        const float p_left = sum > 0.0 ? (share < least ? least : share > most ? most : share) : 0.5;
        const bool goes_right = follow ? ((trail >> depth) & 1u) != 0u : way.u >= p_left;
        const float p = goes_right ? 1.0 - p_left : p_left;
        way.pmf *= p;
        way.u = (goes_right ? way.u - p_left : way.u) / p;
        way.step /= p;
        const bool worn = way.step > 1.0 / 4096.0;
        way.u = worn ? way.u + way.step * rng_to_float(digits) : way.u;
        way.u = min(way.u, LIGHT_PICK_BELOW_ONE);
        digits = worn ? rng_hash(digits) : digits;
        way.step = worn ? LIGHT_PICK_STEP : way.step;
        child = goes_right ? right_b.w : left_b.w;
        node = 2u * node + (goes_right ? 1u : 0u);
    }
    way.light = child & LIGHT_TREE_INDEX;
    return way;
}

// A light's trail; NO_TRAIL for one that is not in the tree.
uint light_tree_trail(uint light) {
    const uvec4 four = fetch_light(frame.trails_first + (light >> 2));
    const uvec2 two = (light & 2u) != 0u ? four.zw : four.xy;
    return (light & 1u) != 0u ? two.y : two.x;
}

// What the whole tree may bring to the point; 0 where there is none.
float light_tree_importance_of_all(vec3 point, vec3 normal) {
    if (frame.tree_nodes == 0u) return 0.0;
    return light_tree_importance(point, normal, fetch_light(frame.tree_first),
                                 fetch_light(frame.tree_first + 1u));
}

#endif
