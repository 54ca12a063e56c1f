// BIND_FRAME: what all kernels of a render know. Written once by the host.
#ifndef AJAR_FRAME_GLSL_H
#define AJAR_FRAME_GLSL_H
#include "dual.glsl.h"
#include "film.glsl.h"
#include "light_visibility.glsl.h"
DUAL_BEGIN

// A table's content when it is read through a pointer instead of a texel buffer.
struct TableWord {
    uvec4 value;
};
DUAL_SIZE(TableWord, 16);
DUAL_PTR(TableWord);
struct Texel {
    uint rgba8;
};
DUAL_SIZE(Texel, 4);
DUAL_PTR(Texel);
struct PixelIndex {
    uint packed; // x | y << 16
};
DUAL_SIZE(PixelIndex, 4);
DUAL_PTR(PixelIndex);

struct FrameRecord {
    TableWordPtr nodes;
    TableWordPtr triangles;
    TableWordPtr surfaces;
    TableWordPtr instances;
    TableWordPtr materials;
    TexelPtr texels;
    TableWordPtr lights;
    TableWordPtr environment;
    PixelIndexPtr pixel_order;   // pixel of each ordinal, in Morton order
    AovPixelPtr aovs;            // by ordinal; 0 when no AOV is asked for
    DiagnosticsPtr diagnostics;
    TableWordPtr visibility;
    VisibilityCountPtr visibility_counts;
    TableWordPtr patches;

    vec3 camera_origin;          // world, metres
    // Perspective: tan of half the horizontal angle; orthographic: half width, metres
    float camera_scale_x;
    vec3 camera_right;           // world, unit
    float camera_scale_y;
    vec3 camera_up;
    uint width;                  // pixels
    vec3 camera_back;            // +Z of the camera
    uint height;

    uint seed;
    uint max_bounces;            // indirect bounces; 0: emission and direct light
    uint rr_depth;               // Russian roulette from this bounce on
    vec3 background;             // constant environment, radiance (W/(m^2 sr)); 0 where there is a map
    float filter_radius;         // pixels; which filter: SPEC_OPTION of generate
    vec3 environment_scale;
    float environment_cos;       // rotation about +Y
    float environment_sin;
    uint environment_width;      // texels of the map, 0: none
    uint environment_height;
    uint environment_light;      // LightRecord of the environment, or NO_LIGHT
    uint light_count;
    uint alias_first;            // texel in BIND_LIGHTS where the alias table begins
    uint textures_first;         // texel in BIND_MATERIALS where TextureRecords begin
    uint root;                   // root node of the whole scene
    vec3 scene_center;           // bounding sphere of the scene
    float scene_radius;
    uint cull_backfaces;         // 1: single-sided triangles are not there from behind
    uint instance_count;
    float ao_distance;           // reach of the ao integrator, metres
    uint distant_first;          // texel in BIND_LIGHTS: alias table over lights that are nowhere
    uint distant_slots;          // its entries: 0 or a power of two
    float distant_irradiance;    // of those lights together, luminance, W/m^2
    uint tree_first;             // texel in BIND_LIGHTS: light tree
    uint tree_lights;            // 0: no light is somewhere, so there is no tree
    uint trails_first;           // texel in BIND_LIGHTS: trails, four a texel
    float sample_clamp;          // no channel of a sample is above this
    uint sequence_log2;          // blue noise: the sequence has 2^sequence_log2 samples a pixel
    uint soft_first;             // the first LightRecord that a ray must be tried against (light.glsl.h)
    uint soft_count;
    uint patch_nodes_first;      // texel in BIND_PATCHES: PatchNodes; roots by triangle come before them
    uint patch_sides_first;      // texel in BIND_PATCHES: PatchSides
    uint pool_paths;             // slots of BIND_RADIANCE; words of the vertices left lie behind them
    uint pad;
};
DUAL_SIZE(FrameRecord, 336);

// SPEC_OPTION of generate.
const uint FILTER_BOX = 0;
const uint FILTER_GAUSSIAN = 1;
const uint FILTER_BLACKMAN_HARRIS = 2;

DUAL_END
#endif
