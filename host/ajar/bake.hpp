// Bakes the light of a scene for other programs: into a glTF file that looks the same without any light.
#pragma once

#include "ajar/device.hpp"
#include "ajar/scene_file.hpp"
#include "bake/settings.hpp"
#include "base/events.hpp"
#include "image/image.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace ajar {

struct BakeResult {
    std::vector<std::byte> glb;      // a .glb file; empty when stopped before the first sample
    std::optional<Image> irradiance; // of a lightmap: W/m^2 by texel, linear Rec. 709
    std::uint32_t samples = 0;       // of each texel or patch, done
    std::uint64_t elements = 0;      // texels or patches
    bool interrupted = false;        // the progress callback said stop
    bool out_of_time = false;        // settings.render.time_limit was reached
    double seconds = 0;              // of computing light
    std::uint64_t rays = 0;
    // What should not happen; 0 in a good bake.
    std::uint64_t invalid_samples = 0;   // NaN, infinite or negative: counted as black
    std::uint64_t saturated_samples = 0; // brighter than 2^24: cut there
    std::uint64_t exhausted_loops = 0;   // rays whose search for a hit was given up
    std::string manifest;                // a JSON document, as RenderResult's
};

// progress: stage "bake", in samples of each texel or patch; return false to stop and keep what is done.
// Throws Error: a scene without light, without triangles, without area, an atlas too small for its charts.
BakeResult bake(const SceneFile& scene, const Device& device, const BakeSettings& settings = {},
                const ProgressSink& progress = {}, const WarningSink& warn = {});

// The files that save_bake writes: `path`, which ends in .glb, and for a lightmap the same name with .exr.
std::vector<std::filesystem::path> bake_files(const std::filesystem::path& path,
                                              const BakeSettings& settings);

// Each file is replaced in one step.
void save_bake(const std::filesystem::path& path, const BakeResult& result);

// Throws the Error that save_bake would, as far as names can tell, before hours of work.
void check_bake_files(const std::filesystem::path& path, const BakeSettings& settings);

} // namespace ajar
