// material_functions: applies one function of shaders/material to each of `count` items, for tests.
// SPEC_OPTION:
// MATERIAL_*. Reads texture coordinates (u0, v0, u1, v1); writes MATERIAL_WORDS words an item.
#ifndef AJAR_MATERIAL_FUNCTIONS_GLSL_H
#define AJAR_MATERIAL_FUNCTIONS_GLSL_H
#include "../../../../shaders/shared/frame.glsl.h"
DUAL_BEGIN

const uint MATERIAL_TEXTURE = 0; // of texture `index`. Out: the sample
// Of material `index`. Out: base colour; emission, metallic; normal, alpha_ggx; f0, f90; then material_alpha
// and material_emission.
const uint MATERIAL_POINT = 1;
const uint MATERIAL_WORDS = 5;

struct MaterialFunctionsArgs {
    TableWordPtr items_in;
    TableWordPtr items_out;
    vec4 vertex_color;
    uint count;
    uint index;
};
DUAL_SIZE(MaterialFunctionsArgs, 40);

DUAL_END
#endif
