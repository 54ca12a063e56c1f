// The one descriptor set that all kernels share: binding numbers (set 0).
#ifndef AJAR_BINDINGS_GLSL_H
#define AJAR_BINDINGS_GLSL_H
#include "dual.glsl.h"
DUAL_BEGIN

// Uniform buffer: FrameRecord.
const uint BIND_FRAME = 0;

// Storage buffers: what kernels write.
const uint BIND_PATHS = 1;       // PathState[pool size]
const uint BIND_SHADOW_RAYS = 2; // ShadowRay[pool size]
const uint BIND_SEGMENTS = 3;    // SegmentCounts[segments]
const uint BIND_RADIANCE = 4;    // vec4[pool size], by the path's home slot
const uint BIND_FILM = 5;        // FilmPixel[chunk]
const uint BIND_STORAGE_FIRST = BIND_PATHS;
const uint BIND_STORAGE_LAST = BIND_FILM;

// Texel buffers, all RGBA32UI but TEXELS, which is RGBA8 UNORM. First three of the storage buffers again, for
// kernels that read them faster that way (SPEC_PATH_TEXELS); a dispatch never reads there what it wrote
// itself.
const uint BIND_PATHS_READ = 6;
const uint BIND_SHADOW_RAYS_READ = 7;
const uint BIND_RADIANCE_READ = 8;
// Then the read-only scene tables.
const uint BIND_NODES = 9;        // BVH nodes
const uint BIND_TRIANGLES = 10;   // triangles in leaf order, for intersection
const uint BIND_SURFACES = 11;    // per triangle: normals, texture coordinates, material, light
const uint BIND_INSTANCES = 12;   // InstanceRecord
const uint BIND_MATERIALS = 13;   // MaterialRecord and TextureRecord
const uint BIND_TEXELS = 14;      // all textures' texels
const uint BIND_LIGHTS = 15;      // LightRecord and the light samplers' tables
const uint BIND_ENVIRONMENT = 16; // radiance and distribution of the environment map
// And what was learned about them (light_visibility.glsl.h).
const uint BIND_VISIBILITY = 17;
// And its patches with what radiosity found for them (patch.glsl.h).
const uint BIND_PATCHES = 18;
const uint BIND_TABLE_FIRST = BIND_NODES;
const uint BIND_TABLE_LAST = BIND_ENVIRONMENT;
const uint TABLE_COUNT = 8;
const uint BIND_TEXEL_FIRST = BIND_PATHS_READ;
const uint BIND_TEXEL_LAST = BIND_PATCHES;
const uint TEXEL_BINDING_COUNT = 13;

const uint BIND_COUNT = 19;

DUAL_END
#endif
