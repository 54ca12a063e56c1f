// BIND_LIGHTS: LightRecords, then the light samplers' tables: alias tables over all lights and over the
// distant ones, the light tree (light_tree.glsl.h). FrameRecord says where each begins.
#ifndef AJAR_LIGHT_GLSL_H
#define AJAR_LIGHT_GLSL_H
#include "dual.glsl.h"
DUAL_BEGIN

const uint LIGHT_TRIANGLE = 0;
const uint LIGHT_POINT = 1;
const uint LIGHT_SPOT = 2;
const uint LIGHT_DIRECTIONAL = 3;
const uint LIGHT_ENVIRONMENT = 4; // at most one: map or constant
const uint LIGHT_SPHERE = 5;      // point and spot lights with a radius, meshes that are spheres
const uint LIGHT_SUN = 6;         // directional lights with an angular diameter

const uint LIGHT_TWO_SIDED = 1u << 8;  // triangle: emits from its back as well (bit of LightRecord::kind)
const uint LIGHT_TEXTURED = 1u << 9;   // triangle: emission is looked up at the sampled point
const uint LIGHT_LAMP = 1u << 10;     // sphere, sun: a punctual light, which the camera does not see
const uint LIGHT_UNMET = 1u << 11;    // sphere, sun: light sampling alone finds it (see MAX_SOFT_LIGHTS)
const uint LIGHT_KIND_MASK = 0xffu;

// Spheres and suns have extent but are in no hierarchy: BSDF sampling meets them by trying each of the
// records [FrameRecord::soft_first, soft_first + soft_count), at most this many.
const uint MAX_SOFT_LIGHTS = 64;

// What fields mean depends on the kind:
//   triangle:    p0 p1 p2 = world-space vertices, winding as the front face sees it; radiance = W/(m^2 sr)
//   point, spot: p0 = position; radiance = intensity in W/sr; p1 = direction (spot); p2 = (1/range^2 or 0,
//                angle scale, angle offset) of KHR_lights_punctual
//   directional: p1 = direction the light travels; radiance = irradiance at normal incidence, W/m^2
//   environment: radiance = scale
//   directional, environment, sun: p2.x = share among these lights that are nowhere, by irradiance
//   sphere:      p0 = centre; radiance = W/(m^2 sr), times what p1 and p2 say as for a spot light
//   sun:         p0 = direction towards it, unit; radiance = W/(m^2 sr)
struct LightRecord {
    vec3 p0;
    uint kind;      // LIGHT_* with its flag bits
    vec3 p1;
    uint triangle;  // triangle: index in leaf order (its instance is 0), for surface look-ups and exclusion
    vec3 p2;
    float power_pmf; // probability that the power sampler picks this light
    vec3 radiance;
    float extent;    // sphere: radius, metres; sun: 1 - cos of half its angular diameter
};
DUAL_SIZE(LightRecord, 64);

const uint LIGHT_TEXELS = 4;

// Each side of an environment map's distribution has at most 2^this cells.
const int ENVIRONMENT_CELL_BITS = 11;

// Alias method (Walker 1977; Vose 1991): take entry i = floor(u n); keep i when the remapped u < keep, else
// `other`.
struct AliasEntry {
    float keep;
    uint other;
    uint own;  // i, or what it stands for
    uint pad;
};
DUAL_SIZE(AliasEntry, 16);

DUAL_END
#endif
