// light_functions: applies one function of shaders/lights to many items.
#ifndef AJAR_LIGHT_FUNCTIONS_GLSL_H
#define AJAR_LIGHT_FUNCTIONS_GLSL_H
#include "../../../../shaders/shared/dual.glsl.h"
DUAL_BEGIN

// SPEC_OPTION.
const uint LIGHTS_SAMPLE = 0; // point, light, uv -> LightSample
const uint LIGHTS_PICK = 1;   // point, normal = direction, uv.x -> light, pdf = pmf, direction.x = rest of u;
                              //   distance = pmf of that light, asked again
const uint LIGHTS_ENVIRONMENT = 2;  // direction -> radiance, pdf
const uint LIGHTS_TRIANGLE_PDF = 3; // direction, distance, normal = point, area = uv.x -> pdf

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
