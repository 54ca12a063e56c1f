// Specialization constants: id numbers for the host, and their declarations for kernels
// (shaders/core/variants.glsl).
#ifndef AJAR_SPECIALIZATION_GLSL_H
#define AJAR_SPECIALIZATION_GLSL_H
#include "dual.glsl.h"
DUAL_BEGIN

const uint SPEC_WORKGROUP_SIZE = 0; // threads per workgroup; kernels over segments: one workgroup per segment
const uint SPEC_SEGMENT_SIZE = 1;   // path slots per segment, a multiple of the workgroup size
const uint SPEC_TEXEL_BUFFERS = 2;  // 1: scene tables are read through texel buffers, 0: through pointers
const uint SPEC_FEATURES = 3;       // what the scene has: FEATURE_* bits; code for the rest is compiled out
const uint SPEC_STRATEGY = 4;       // STRATEGY_*: which sampling sees the luminaires
const uint SPEC_LIGHT_SAMPLER = 5;  // LIGHT_SAMPLER_*
const uint SPEC_OPTION = 6;         // a kernel's own variant, named in its header
// 1: paths and shadow rays are read through texel buffers (lavapipe: branch-free)
const uint SPEC_PATH_TEXELS = 7;
// Groups of a traversal's stack that are in registers; 0: it is in memory
const uint SPEC_STACK_REGISTERS = 8;
const uint SPEC_HEURISTIC = 10; // HEURISTIC_*: how STRATEGY_MIS weighs its two samplings
const uint SPEC_TRACE_SHARES = 11; // workgroups that share a segment in extend and connect; a power of two
const uint SPEC_SAMPLER = 9;        // SAMPLER_*: where random numbers come from

const uint FEATURE_INSTANCES = 1u << 0;       // two-level hierarchy
const uint FEATURE_ALPHA = 1u << 1;           // some triangles need an alpha or facing test when hit
const uint FEATURE_TEXTURES = 1u << 2;        // any texture at all
const uint FEATURE_NORMAL_MAPS = 1u << 3;
// Second texture coordinates, tangents or vertex colours are stored
const uint FEATURE_EXTENDED_SURFACE = 1u << 4;
const uint FEATURE_SPECULAR = 1u << 5;        // any material with a microfacet lobe (else all are Lambertian)
const uint FEATURE_DELTA = 1u << 6;           // any material smooth enough for a delta lobe
const uint FEATURE_EMISSIVE_TRIANGLES = 1u << 7;
const uint FEATURE_PUNCTUAL_LIGHTS = 1u << 8;
const uint FEATURE_ENVIRONMENT_MAP = 1u << 9; // importance-sampled map
const uint FEATURE_CONSTANT_ENVIRONMENT = 1u << 10;
const uint FEATURE_UNLIT = 1u << 11;
const uint FEATURE_EMISSION_TEXTURES = 1u << 12;
const uint FEATURE_ORTHOGRAPHIC = 1u << 13;
const uint FEATURE_SOFT_LIGHTS = 1u << 14;    // spheres, and suns of some width
const uint FEATURE_WIDE_TRIANGLES = 1u << 15; // emissive triangles are sampled by solid angle, not by area

const uint STRATEGY_BSDF = 0;
const uint STRATEGY_LIGHT = 1;
const uint STRATEGY_MIS = 2;

const uint HEURISTIC_POWER = 0; // exponent 2
const uint HEURISTIC_BALANCE = 1;

const uint LIGHT_SAMPLER_POWER = 0;
const uint LIGHT_SAMPLER_UNIFORM = 1;
const uint LIGHT_SAMPLER_TREE = 2;
const uint LIGHT_SAMPLER_VISIBILITY = 3;

const uint SAMPLER_SOBOL = 0;
const uint SAMPLER_INDEPENDENT = 1;
const uint SAMPLER_BLUE_NOISE = 2;

DUAL_END
#endif
