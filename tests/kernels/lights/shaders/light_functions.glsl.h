// light_functions: applies one function of shaders/lights to many items.
#ifndef AJAR_LIGHT_FUNCTIONS_GLSL_H
#define AJAR_LIGHT_FUNCTIONS_GLSL_H
#include "../../../../shaders/shared/dual.glsl.h"
DUAL_BEGIN

// SPEC_OPTION.
const uint LIGHTS_SAMPLE = 0;       // point, light, uv -> LightSample
// In: point, normal (direction), lobe (triangle: receiver.glsl's word), uv. Out: light, pmf (pdf), rest of u,
// filled in (uv)
const uint LIGHTS_PICK = 1;
const uint LIGHTS_PMF = 2; // point, direction = normal, triangle = lobe, light -> pdf = pmf
const uint LIGHTS_ENVIRONMENT = 3;  // direction -> radiance, pdf
const uint LIGHTS_TRIANGLE_PDF = 4; // point, direction, triangle -> pdf

// point, direction, distance = limit, delta = from the camera -> triangle = how many soft lights are met,
// light = the first of them with its radiance and pdf
const uint LIGHTS_SOFT = 5;

struct LightItem {
    vec3 point;
    uint light;
    vec3 direction;
    float distance;
    vec3 radiance;
    float pdf;
    vec2 uv;
    uint delta;
    uint triangle;
};
DUAL_SIZE(LightItem, 64);
DUAL_PTR(LightItem);

struct LightFunctionsArgs {
    LightItemPtr items; // read and overwritten
    uint count;
    uint pad;
};
DUAL_SIZE(LightFunctionsArgs, 16);

DUAL_END
#endif
