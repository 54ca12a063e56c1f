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

// What is below the children of a node, decoded: a component each, so that the four are worked out side by
// side, where one after the other each would wait for its own results.
struct LightTreeBounds {
    vec4 x; // centres, from the receiver, metres
    vec4 y;
    vec4 z;
    vec4 radius;
    vec4 axis_x; // times LIGHT_TREE_SNORM
    vec4 axis_y;
    vec4 axis_z;
    vec4 cos_normals;
    vec4 cos_emission;
    vec4 intensity;
    bvec4 two_sided;
};

// Bytes of a word, as numbers from -1 to 1.
vec4 light_tree_snorm(uint word) {
    return vec4(ivec4(word << 24, word << 16, word << 8, word) >> 24) * (1.0 / float(LIGHT_TREE_SNORM));
}

// Comparisons, not min, max and clamp: those take three instructions each on lavapipe.
vec4 light_tree_above(vec4 x, float least) { return mix(vec4(least), x, greaterThan(x, vec4(least))); }
vec4 light_tree_cosine(vec4 x) {
    const vec4 above = light_tree_above(x, LIGHT_TREE_GRAZING);
    return mix(vec4(1.0), above, lessThan(above, vec4(1.0)));
}

// What the lights may bring to the receiver: irradiance (luminance, W/m^2; intensity cos cos' / d^2, the
// cosines at their best over the sphere), or, where it has a lobe, in proportion to what leaves it towards
// its viewer: the cosine for the part of its BSDF that is diffuse, and for its lobe GGX about the reflected
// direction, widened by the solid angle that the light comes from, so that a lobe within a large sphere
// counts with its share of it. 0 where none can arrive.
// Cosines are had by dividing products by the distance at the end: nothing waits for a unit direction.
vec4 light_tree_importance(LightReceiver at, LightTreeBounds b) {
    const vec4 distance2 = b.x * b.x + b.y * b.y + b.z * b.z;
    const vec4 radius2 = b.radius * b.radius;
    const bvec4 outside = greaterThan(distance2, radius2);
    const vec4 nearest2 = light_tree_above(mix(radius2, distance2, outside), 1e-36);
    const vec4 inverse2 = 1.0 / nearest2;
    const vec4 distance = sqrt(nearest2);
    const vec4 inverse = distance * inverse2;
    const vec4 sine = b.radius * inverse; // of half the angle that the sphere covers
    const vec4 along = (b.axis_x * b.x + b.axis_y * b.y + b.axis_z * b.z) * (-1.0 / float(LIGHT_TREE_SNORM));
    const vec4 to_axis = mix(along, abs(along), b.two_sided); // distance times the cosine
    // To the nearest normal.
    const vec4 aside = sqrt(light_tree_above(nearest2 - to_axis * to_axis, 0.0));
    const vec4 sin_normals = sqrt(light_tree_above(1.0 - b.cos_normals * b.cos_normals, 0.0));
    const vec4 beyond = (to_axis * b.cos_normals + aside * sin_normals) * inverse;
    const vec4 nearest = mix(beyond, vec4(1.0), greaterThan(to_axis, b.cos_normals * distance));
    const vec4 arriving = (at.normal.x * b.x + at.normal.y * b.y + at.normal.z * b.z + b.radius) * inverse;
    // Twice: where light leaves less than half a sphere, the sum above may fall short of the exact bound.
    const bvec4 leaves = greaterThan(nearest + 2.0 * sine, b.cos_emission - LIGHT_TREE_GRAZING);
    const bvec4 arrives = greaterThan(arriving, vec4(-LIGHT_TREE_GRAZING));
    vec4 scattered = light_tree_cosine(arriving);
    if (has_feature(FEATURE_SPECULAR)) {
        const vec4 to_lobe = at.lobe.x * b.x + at.lobe.y * b.y + at.lobe.z * b.z;
        const vec4 width = at.alpha2 + 0.25 * (radius2 * inverse2); // half vectors turn half as far
        // 1 / (4 width (1 + tan^2 / width)^2), tan of the half vector's angle: tan^2 = (1 - cos) / (1 + cos).
        const vec4 ahead = distance + to_lobe;
        const vec4 ratio = ahead / (width * ahead + (distance - to_lobe));
        scattered += at.specular * (0.25 * width * ratio * ratio - scattered);
    }
    const vec4 intensity = b.intensity * inverse2;
    const vec4 brought = intensity * light_tree_cosine(nearest + sine) * scattered;
    return mix(intensity, mix(vec4(0.0), mix(vec4(0.0), brought, leaves), arrives), outside);
}

struct LightTreeWay {
    float pmf;  // product of the decisions' probabilities
    float u;    // what is left of u
    float step; // of its digits
    uint light;
};

// The children of a node. `corner` and `step`: from the receiver to the low corner of the node's sphere's
// box, and what one step of a place is, metres; `radius` of that sphere.
LightTreeBounds light_tree_children(vec3 corner, float step, float radius, uvec4 places, uvec4 axes,
                                    uvec4 cones) {
    LightTreeBounds b;
    b.x = corner.x + step * vec4(ivec4(places & LIGHT_TREE_PLACE_STEPS));
    b.y = corner.y + step * vec4(ivec4((places >> 10) & LIGHT_TREE_PLACE_STEPS));
    b.z = corner.z + step * vec4(ivec4((places >> 20) & LIGHT_TREE_PLACE_STEPS));
    const vec4 root = vec4(ivec4(uvec4(cones.x, cones.x >> 8, cones.x >> 16, cones.x >> 24) & 255u));
    b.radius = radius * root * root;
    b.axis_x = vec4(ivec4(axes << 24) >> 24);
    b.axis_y = vec4(ivec4(axes << 16) >> 24);
    b.axis_z = vec4(ivec4(axes << 8) >> 24);
    b.cos_normals = light_tree_snorm(cones.y);
    b.cos_emission = light_tree_snorm(cones.z);
    const uvec4 level = axes >> 24;
    b.intensity = mix(vec4(0.0), uintBitsToFloat((level << 20) + (LIGHT_TREE_EXPONENT << 23)),
                      notEqual(level, uvec4(0u)));
    b.two_sided = notEqual(places & LIGHT_TREE_TWO_SIDED, uvec4(0u));
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
    uint first = frame.tree_first + LIGHT_TREE_NODE_TEXELS; // texel of node 0
    uint next = first;
    uint chosen = 0u;
    uint heap = 1u; // as in a heap of fours; runs over below the levels that are learned about
    // Left at its end: where a test at the head fails, lavapipe runs the body once more, for nobody.
    for (uint depth = 0u; depth < LIGHT_TREE_MAX_DEPTH; ++depth) {
        first = next;
        const uvec4 places = fetch_light(first);
        const uvec4 axes = fetch_light(first + 1u);
        const uvec4 cones = fetch_light(first + 2u);
        const vec3 corner = sphere.xyz - sphere.w;
        const float step = sphere.w * (2.0 / float(LIGHT_TREE_PLACE_STEPS));
        const float radius = sphere.w * (1.0 / float(LIGHT_TREE_RADIUS_STEPS * LIGHT_TREE_RADIUS_STEPS));
        const LightTreeBounds below = light_tree_children(corner, step, radius, places, axes, cones);
        vec4 share = light_tree_importance(at, below);
        if (LIGHT_SAMPLER_LEARNS) share *= visibility_of_children(cell, heap);
        const float total = (share.x + share.y) + (share.z + share.w);
        const float least = total * LIGHT_TREE_LEAST;
        share.x = light_tree_share(share.x, least, total, below.intensity.x);
        share.y = light_tree_share(share.y, least, total, below.intensity.y);
        share.z = light_tree_share(share.z, least, total, below.intensity.z);
        share.w = light_tree_share(share.w, least, total, below.intensity.w);
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
        next = frame.tree_first +
               LIGHT_TREE_NODE_TEXELS * (1u + (cones.w & LIGHT_TREE_FIRST) + chosen);
        const vec4 sphere_ab = beyond0 ? vec4(below.x.y, below.y.y, below.z.y, below.radius.y)
                                       : vec4(below.x.x, below.y.x, below.z.x, below.radius.x);
        const vec4 sphere_cd = beyond2 ? vec4(below.x.w, below.y.w, below.z.w, below.radius.w)
                                       : vec4(below.x.z, below.y.z, below.z.z, below.radius.z);
        sphere = beyond1 ? sphere_cd : sphere_ab;
        heap = 4u * heap + chosen;
        if (chosen >= cones.w >> LIGHT_TREE_COUNT_SHIFT) break;
    }
    const uvec4 lights = fetch_light(first + 3u);
    const uvec2 two = chosen > 1u ? lights.zw : lights.xy;
    way.light = (chosen & 1u) != 0u ? two.y : two.x;
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
    const vec3 to_center = uintBitsToFloat(sphere.xyz) - at.point;
    const ivec3 axis = ivec3(rest.x << 24, rest.x << 16, rest.x << 8) >> 24;
    LightTreeBounds b;
    b.x = vec4(to_center.x);
    b.y = vec4(to_center.y);
    b.z = vec4(to_center.z);
    b.radius = vec4(uintBitsToFloat(sphere.w));
    b.axis_x = vec4(float(axis.x));
    b.axis_y = vec4(float(axis.y));
    b.axis_z = vec4(float(axis.z));
    b.cos_normals = light_tree_snorm(rest.y).xxxx;
    b.cos_emission = light_tree_snorm(rest.y).yyyy;
    b.intensity = vec4(uintBitsToFloat(rest.z));
    b.two_sided = bvec4((rest.w & LIGHT_TREE_TWO_SIDED) != 0u);
    return light_tree_importance(at, b).x;
}

#endif
