// Which dimension of the sample sequence decides what. Even dimensions begin a jointly stratified pair
// (sampler_2d).
#ifndef AJAR_DIMENSIONS_GLSL_H
#define AJAR_DIMENSIONS_GLSL_H
#include "dual.glsl.h"
DUAL_BEGIN

const uint DIM_PIXEL = 0; // and 1: place on the film
const uint DIM_LENS = 2;  // and 3: place on the lens

// Bounce b (0: the camera ray's hit) owns [DIM_BOUNCE_FIRST + b * DIM_PER_BOUNCE, ... + DIM_PER_BOUNCE).
const uint DIM_BOUNCE_FIRST = 4;
const uint DIM_PER_BOUNCE = 8;
const uint DIM_BSDF = 0;       // and 1: direction
const uint DIM_LIGHT = 2;      // and 3: which light, and place on it
const uint DIM_BSDF_LOBE = 4;  // which lobe
const uint DIM_LIGHT_DIGITS = 5; // of the place, where picking one of many lights used them up
const uint DIM_PER_LIGHT = 65536; // where all lights have their turn, light l adds (l + 1) times this
const uint DIM_ROULETTE = 6;   // whether the path goes on; 7 is free

DUAL_END
#endif
