// patch_functions: looks many points up by radiosity/patch_lookup.glsl, for tests.
#ifndef AJAR_PATCH_FUNCTIONS_GLSL_H
#define AJAR_PATCH_FUNCTIONS_GLSL_H
#include "../../../../shaders/shared/dual.glsl.h"
DUAL_BEGIN

// In: triangle in leaf order and barycentrics. Out: patch, and barycentrics within it.
struct PatchItem {
    uint index;
    float u;
    float v;
};
DUAL_SIZE(PatchItem, 12);
DUAL_PTR(PatchItem);

struct PatchFunctionsArgs {
    PatchItemPtr items; // read and overwritten
    uint count;
    uint pad;
};
DUAL_SIZE(PatchFunctionsArgs, 16);

DUAL_END
#endif
