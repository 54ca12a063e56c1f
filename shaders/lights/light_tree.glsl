// The light tree: how much the lights below a node may bring to a point, and the way down to one of them by a
// single random number (Conty Estevez and Kulla 2018; bounds of cosines over a cone as in Pharr et al. 2023,
// section 12.6.3, with spheres for boxes). Where a cosine is bounded over a sphere, the sine of half the
// angle that it covers is added: no less than the exact bound where that is positive, and without its roots.
// So a light that can light the point is never out of reach.
#ifndef AJAR_LIGHT_TREE_GLSL
#define AJAR_LIGHT_TREE_GLSL
#include "../core/math.glsl"
#include "../core/rng.glsl"
#include "../shared/light_tree.glsl.h"
#include "light_pick.glsl"
#include "light_visibility.glsl"
#include "receiver.glsl"

// Cosines below this count as this: light that just grazes is still light, and axes of 8 bits are off by up
// to 0.007.
const float LIGHT_TREE_GRAZING = 0.01;
const float LIGHT_TREE_LEAST = 9.5367431640625e-7; // 2^-20: least share of a decision that is not none

// What is below a node, decoded.
struct LightTreeBounds {
    vec3 to_center; // from the receiver, metres
    float radius;
    vec3 axis;      // times LIGHT_TREE_SNORM
    float cos_normals;
    float cos_emission;
    float intensity;
    bool two_sided;
};

float light_tree_snorm(uint word, uint byte) {
    return float(int(word << (24u - 8u * byte)) >> 24) * (1.0 / float(LIGHT_TREE_SNORM));
}
vec3 light_tree_axis(uint word) { return vec3(ivec3(word << 24, word << 16, word << 8) >> 24); }

// Comparisons, not min, max and clamp: those take three instructions each on lavapipe.
float light_tree_cosine(float x) {
    const float above = x > LIGHT_TREE_GRAZING ? x : LIGHT_TREE_GRAZING;
    return above < 1.0 ? above : 1.0;
}
float light_tree_other_leg(float cosine) {
    const float rest = 1.0 - cosine * cosine;
    return sqrt(rest > 0.0 ? rest : 0.0);
}

// What reaches the receiver's viewer of light from direction w (unit), in proportion: the cosine for the part
// of its BSDF that is diffuse, and for its lobe GGX about the reflected direction, widened by the solid angle
// that the light comes from (`sine` of half of it), so that a lobe within a large sphere counts with its
// share of it.
float light_tree_scatter(LightReceiver at, vec3 w, float cosine, float sine) {
    if (!has_feature(FEATURE_SPECULAR)) return cosine;
    const float along = dot(at.lobe, w);
    const float width = at.alpha2 + 0.25 * sine * sine; // half vectors turn half as far as directions
    // 1 / (4 width (1 + tan^2 / width)^2), tan of the half vector's angle: tan^2 = (1 - along) / (1 + along).
    const float ratio = (1.0 + along) / (width * (1.0 + along) + (1.0 - along));
    const float lobe = 0.25 * width * ratio * ratio;
    return cosine + at.specular * (lobe - cosine);
}

// What the lights may bring to the receiver: irradiance (luminance, W/m^2; intensity cos cos' / d^2, the
// cosines at their best over the sphere), or, where it has a lobe, in proportion to what leaves it towards
// its viewer. 0 where none can arrive.
float light_tree_importance(LightReceiver at, LightTreeBounds b) {
    const float distance2 = dot(b.to_center, b.to_center);
    const float radius2 = b.radius * b.radius;
    const bool outside = distance2 > radius2;
    const float nearest2 = outside ? distance2 : radius2;
    const float inverse = inversesqrt(nearest2 > 1e-36 ? nearest2 : 1e-36);
    const vec3 w = b.to_center * inverse;
    const float sine = b.radius * inverse; // of half the angle that the sphere covers
    const float along = dot(b.axis, w) * (-1.0 / float(LIGHT_TREE_SNORM));
    const float cos_axis = b.two_sided ? abs(along) : along;
    // To the nearest normal.
    const float beyond = cos_axis * b.cos_normals +
                         light_tree_other_leg(cos_axis) * light_tree_other_leg(b.cos_normals);
    const float nearest = cos_axis > b.cos_normals ? 1.0 : beyond;
    const float arriving = dot(at.normal, w) + sine;
    // Twice: where light leaves less than half a sphere, the sum above may fall short of the exact bound.
    const bool reaches = nearest + 2.0 * sine > b.cos_emission - LIGHT_TREE_GRAZING &&
                         arriving > -LIGHT_TREE_GRAZING;
    const float scattered = light_tree_scatter(at, w, light_tree_cosine(arriving), sine);
    const float intensity = b.intensity * inverse * inverse;
    const float brought = intensity * light_tree_cosine(nearest + sine) * scattered;
    return outside ? (reaches ? brought : 0.0) : intensity;
}

struct LightTreeWay {
    float pmf;  // product of the decisions' probabilities
    float u;    // what is left of u
    float step; // of its digits
    uint light;
};

// Child k of a node. `corner` and `step`: from the receiver to the low corner
// of the node's sphere's box, and what one step of a place is, metres; `radius` of that sphere.
LightTreeBounds light_tree_child(vec3 corner, float step, float radius, uint place, uint axis, uvec4 cones,
                                 uint k) {
    LightTreeBounds b;
    const uvec3 steps = uvec3(place, place >> 10, place >> 20) & LIGHT_TREE_PLACE_STEPS;
    b.to_center = corner + step * vec3(ivec3(steps));
    const float root = float(int((cones.x >> (8u * k)) & 255u));
    b.radius = radius * root * root;
    b.axis = light_tree_axis(axis);
    b.cos_normals = light_tree_snorm(cones.y, k);
    b.cos_emission = light_tree_snorm(cones.z, k);
    const uint level = axis >> 24;
    b.intensity = level != 0u ? uintBitsToFloat((level << 20) + (LIGHT_TREE_EXPONENT << 23)) : 0.0;
    b.two_sided = (place & LIGHT_TREE_TWO_SIDED) != 0u;
    return b;
}

// A child that can bring anything keeps a share that 24 digits can tell from none; where none can, any light
// will do, so that probabilities still sum to 1.
float light_tree_share(float importance, float least, float total, float intensity) {
    const float kept = importance > least ? importance : least;
    return total > 0.0 ? (importance > 0.0 ? kept : 0.0) : (intensity > 0.0 ? 1.0 : 0.0);
}

// Down to a light: by u, or, to learn how probable a light is, along its trail. Both take the same decisions'
// probabilities, to the last bit. What `cell` learned of a node's visibility scales its importance.
LightTreeWay light_tree_descend(LightReceiver at, uint cell, float u, uint trail, bool follow) {
    LightTreeWay way = LightTreeWay(1.0, u, LIGHT_PICK_STEP, 0u);
    // u has 24 digits, and every decision uses some up: more are drawn from a hash of the point, which leaves
    // a long way's probabilities exact on average over points, where 2^24 values of u could not.
    uint digits = rng_combine(floatBitsToUint(u), floatBitsToUint(at.point.x) ^ floatBitsToUint(at.point.z));
    vec4 sphere = uintBitsToFloat(fetch_light(frame.tree_first)); // of the node, from the receiver
    sphere.xyz -= at.point;
    const uint root = fetch_light(frame.tree_first + 1u).w;
    bool inner = (root & LIGHT_TREE_LEAF) == 0u;
    uint first = frame.tree_first + LIGHT_TREE_NODE_TEXELS; // texel of node 0
    uint next = first;
    uint chosen = 0u;
    uint heap = 1u; // as in a heap of fours; runs over below the levels that are learned about
    for (uint depth = 0u; depth < LIGHT_TREE_MAX_DEPTH && inner; ++depth) {
        first = next;
        const uvec4 places = fetch_light(first);
        const uvec4 axes = fetch_light(first + 1u);
        const uvec4 cones = fetch_light(first + 2u);
        const vec3 corner = sphere.xyz - sphere.w;
        const float step = sphere.w * (2.0 / float(LIGHT_TREE_PLACE_STEPS));
        const float radius = sphere.w * (1.0 / float(LIGHT_TREE_RADIUS_STEPS * LIGHT_TREE_RADIUS_STEPS));
        const LightTreeBounds a = light_tree_child(corner, step, radius, places.x, axes.x, cones, 0u);
        const LightTreeBounds b = light_tree_child(corner, step, radius, places.y, axes.y, cones, 1u);
        const LightTreeBounds c = light_tree_child(corner, step, radius, places.z, axes.z, cones, 2u);
        const LightTreeBounds d = light_tree_child(corner, step, radius, places.w, axes.w, cones, 3u);
        vec4 share = vec4(light_tree_importance(at, a), light_tree_importance(at, b),
                          light_tree_importance(at, c), light_tree_importance(at, d));
        if (LIGHT_SAMPLER_LEARNS) share *= visibility_of_children(cell, heap);
        const float total = (share.x + share.y) + (share.z + share.w);
        const float least = total * LIGHT_TREE_LEAST;
        share.x = light_tree_share(share.x, least, total, a.intensity);
        share.y = light_tree_share(share.y, least, total, b.intensity);
        share.z = light_tree_share(share.z, least, total, c.intensity);
        share.w = light_tree_share(share.w, least, total, d.intensity);
        const float s1 = share.x;
        const float s2 = s1 + share.y;
        const float s3 = s2 + share.z;
        const float sum = s3 + share.w;
        const uint wanted = (trail >> (LIGHT_TREE_TRAIL_TOP - 2u - 2u * depth)) & 3u;
        const float target = way.u * sum; // below sum, since u <= 1 - 2^-24
        const bool beyond0 = follow ? wanted > 0u : target >= s1;
        const bool beyond1 = follow ? wanted > 1u : target >= s2;
        const bool beyond2 = follow ? wanted > 2u : target >= s3;
        const float mass = beyond2 ? share.w : (beyond1 ? share.z : (beyond0 ? share.y : share.x));
        const float before = beyond2 ? s3 : (beyond1 ? s2 : (beyond0 ? s1 : 0.0));
        const float scale = 1.0 / mass;
        way.pmf *= mass * (1.0 / sum);
        way.u = (target - before) * scale;
        way.step *= sum * scale;
        const bool worn = way.step > 1.0 / 4096.0;
        way.u = worn ? way.u + way.step * rng_to_float(digits) : way.u;
        way.u = way.u < LIGHT_PICK_BELOW_ONE ? way.u : LIGHT_PICK_BELOW_ONE;
        digits = worn ? rng_hash(digits) : digits;
        way.step = worn ? LIGHT_PICK_STEP : way.step;
        chosen = beyond2 ? 3u : (beyond1 ? 2u : (beyond0 ? 1u : 0u));
        inner = chosen < cones.w >> LIGHT_TREE_COUNT_SHIFT;
        next = frame.tree_first +
               LIGHT_TREE_NODE_TEXELS * (1u + (cones.w & LIGHT_TREE_FIRST) + chosen);
        const vec4 sphere_ab = beyond0 ? vec4(b.to_center, b.radius) : vec4(a.to_center, a.radius);
        const vec4 sphere_cd = beyond2 ? vec4(d.to_center, d.radius) : vec4(c.to_center, c.radius);
        sphere = beyond1 ? sphere_cd : sphere_ab;
        heap = 4u * heap + chosen;
    }
    const uvec4 lights = fetch_light(first + 3u);
    const uvec2 two = chosen > 1u ? lights.zw : lights.xy;
    const uint last = (chosen & 1u) != 0u ? two.y : two.x;
    way.light = (root & LIGHT_TREE_LEAF) != 0u ? root & LIGHT_TREE_INDEX : last;
    return way;
}

// A light's trail; NO_TRAIL for one that is not in the tree.
uint light_tree_trail(uint light) {
    const uvec4 four = fetch_light(frame.trails_first + (light >> 2));
    const uvec2 two = (light & 2u) != 0u ? four.zw : four.xy;
    return (light & 1u) != 0u ? two.y : two.x;
}

// What the whole tree may bring to the point; 0 where there is none.
float light_tree_importance_of_all(LightReceiver at) {
    if (frame.tree_lights == 0u) return 0.0;
    const uvec4 sphere = fetch_light(frame.tree_first);
    const uvec4 rest = fetch_light(frame.tree_first + 1u);
    LightTreeBounds b;
    b.to_center = uintBitsToFloat(sphere.xyz) - at.point;
    b.radius = uintBitsToFloat(sphere.w);
    b.axis = light_tree_axis(rest.x);
    b.cos_normals = light_tree_snorm(rest.y, 0u);
    b.cos_emission = light_tree_snorm(rest.y, 1u);
    b.intensity = uintBitsToFloat(rest.z);
    b.two_sided = (rest.w & LIGHT_TREE_TWO_SIDED) != 0u;
    return light_tree_importance(at, b);
}

#endif
