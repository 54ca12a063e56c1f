// Everything that decides a bake.
#pragma once

#include "render/settings.hpp"

#include <cstdint>
#include <string>

namespace ajar {

struct BakeSettings {
    std::string to = "vertices";   // a row of bake_targets()
    std::string with = "path";     // a row of bake_methods(): what computes the light
    std::uint32_t side = 1024;     // of an atlas, texels
    float patch_size = 0;          // metres: patches' edges are no longer; 0: no limit
    std::uint32_t patches = 20000; // at least so many; on vertices, and for method radiosity
    float exposure = 0;            // EV: what is shown is multiplied by 2^exposure
    // Samples of each texel or patch, seed, bounces, how lights are found, reach of occlusion. What it says
    // of pictures and cameras does not count.
    RenderSettings render;
};

} // namespace ajar
