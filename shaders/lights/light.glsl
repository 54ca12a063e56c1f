// The switch over the kinds of light. Kinds that the scene lacks are compiled out; the rest run masked.
#ifndef AJAR_LIGHT_GLSL
#define AJAR_LIGHT_GLSL
#include "directional.glsl"
#include "environment.glsl"
#include "sphere.glsl"
#include "spot.glsl"
#include "sun.glsl"
#include "triangle.glsl"

const uint FEATURE_ANY_ENVIRONMENT = FEATURE_ENVIRONMENT_MAP | FEATURE_CONSTANT_ENVIRONMENT;

// A direction from `point` (world) towards light `light`, by the density that LightSample::pdf states.
// Unoccluded, radiance / pdf times the BSDF and its cosine estimates what the light brings.
LightSample light_sample(uint light, vec3 point, vec2 u) {
    const LightRecord record = light_fetch(light);
    const uint kind = record.kind & LIGHT_KIND_MASK;
    LightSample s = light_sample_none();
    if (has_feature(FEATURE_EMISSIVE_TRIANGLES)) {
        if (kind == LIGHT_TRIANGLE) s = light_triangle_sample(record, point, u);
    }
    if (has_feature(FEATURE_PUNCTUAL_LIGHTS)) {
        if (kind == LIGHT_POINT) s = light_point_sample(record, point);
        if (kind == LIGHT_SPOT) s = light_spot_sample(record, point);
        if (kind == LIGHT_DIRECTIONAL) s = light_directional_sample(record);
    }
    if (has_feature(FEATURE_ANY_ENVIRONMENT)) {
        if (kind == LIGHT_ENVIRONMENT) s = light_environment_sample(u);
    }
    if (has_feature(FEATURE_SOFT_LIGHTS)) {
        if (kind == LIGHT_SPHERE) s = light_sphere_sample(record, point, u);
        if (kind == LIGHT_SUN) s = light_sun_sample(record, u);
    }
    if (kind != LIGHT_TRIANGLE && kind != LIGHT_SPHERE) s.reach = s.distance;
    return s;
}

#endif
