// The light of a scene, put where other programs find it: in its vertices, in a lightmap, or as ambient
// occlusion.
#pragma once

#include "bake/settings.hpp"
#include "render/render.hpp"

#include <optional>

namespace ajar {

std::span<const Choice> bake_targets();
std::span<const Choice> bake_methods();

struct BakeStats {
    std::uint64_t elements = 0; // texels or patches that light was computed for
    std::uint64_t charts = 0;
    double texels_per_metre = 0; // of the atlas; 0: a texel or two for each chart
    double clipped = 0;          // share of surface whose reflected light is brighter than can be stored
    double exposure_to_fit = 0;  // EV with which nothing would be clipped
    RenderStats render;
};

struct BakeOutput {
    Scene scene;                     // what is shown without any light, ready for export
    std::optional<Image> irradiance; // lightmap: W/m^2 by texel of the atlas, gutter filled
    BakeStats stats;
};

// `scene` must be valid and have a light (or occlusion is asked for). progress: stage "bake", in samples per
// element; return false to stop and keep what is done. Throws Error: no triangles, none with area, no light,
// an atlas too small, unknown names.
BakeOutput bake(const gpu::Device& device, const Scene& scene, const BakeSettings& settings,
                const ProgressSink& progress, const WarningSink& warn);

} // namespace ajar
