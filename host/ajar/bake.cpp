#include "ajar/bake.hpp"

#include "ajar/manifest.hpp"
#include "ajar/version.hpp"
#include "bake/bake.hpp"
#include "base/error.hpp"
#include "base/file.hpp"
#include "export/export.hpp"
#include "image/write.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace ajar {

namespace {

using Json = nlohmann::ordered_json;

std::filesystem::path exr_beside(std::filesystem::path path) { return path.replace_extension(".exr"); }

// What the baked file's look depends on, and no clock.
Json bake_json(const BakeSettings& s, const BakeStats& stats) {
    Json json{{"to", s.to}, {"with", s.with}, {"elements", stats.elements}};
    if (s.to == "vertices")
        json.update({{"patches", s.patches}, {"patch_size", s.patch_size}});
    else
        json.update(
            {{"side", s.side}, {"charts", stats.charts}, {"texels_per_metre", stats.texels_per_metre}});
    if (s.to != "occlusion")
        json.update({{"exposure", s.exposure},
                     {"clipped", stats.clipped},
                     {"exposure_to_fit", stats.exposure_to_fit}});
    return json;
}

std::string with_bake(const std::string& manifest, const Json& bake) {
    Json json = Json::parse(manifest);
    json["bake"] = bake;
    return json.dump(2) + '\n';
}

// What is wrong with a scene is said with its file's name.
BakeOutput bake_scene(const SceneFile& scene, const Device& device, const BakeSettings& settings,
                      const ProgressSink& progress, const WarningSink& warn) {
    try {
        return bake(device, scene.scene(), settings, progress, warn);
    } catch (const Error& error) {
        throw Error(fmt::format("{}: {}", scene.name(), error.what()));
    }
}

} // namespace

BakeResult bake(const SceneFile& scene, const Device& device, const BakeSettings& settings,
                const ProgressSink& progress, const WarningSink& warn) {
    BakeOutput output = bake_scene(scene, device, settings, progress, warn);
    const RenderStats& stats = output.stats.render;
    BakeResult result;
    result.samples = stats.samples;
    result.elements = output.stats.elements;
    result.interrupted = stats.interrupted;
    result.out_of_time = stats.out_of_time;
    result.seconds = stats.render_seconds;
    result.rays = stats.extension_rays + stats.shadow_rays;
    result.invalid_samples = stats.invalid_samples;
    result.saturated_samples = stats.saturated_samples;
    result.exhausted_loops = stats.exhausted_loops;
    if (result.samples == 0) return result;
    // A camera that was made to frame the scene is made again by whoever reads the file.
    if (!scene.has_camera()) output.scene.cameras.clear();
    result.glb = glb_bytes(output.scene, {fmt::format("Ajar {}", version()), warn});
    const std::string hash = scene.hash();
    const Manifest manifest{scene.name(), hash, scene.scene(), device, stats};
    const Json json = bake_json(settings, output.stats);
    result.manifest = with_bake(manifest_json(manifest), json);
    result.irradiance = std::move(output.irradiance);
    if (result.irradiance) {
        result.irradiance->metadata = reproduction_metadata(manifest);
        result.irradiance->metadata.emplace_back("ajar:bake", json.dump());
    }
    return result;
}

std::vector<std::filesystem::path> bake_files(const std::filesystem::path& path,
                                              const BakeSettings& settings) {
    std::vector<std::filesystem::path> files{path};
    if (settings.to == "lightmap") files.push_back(exr_beside(path));
    return files;
}

void save_bake(const std::filesystem::path& path, const BakeResult& result) {
    if (result.irradiance) {
        WriteOptions options;
        options.exr_floats = ExrFloats::full; // sunlight in W/m^2 or lux is beyond half's 65504
        write_image(exr_beside(path), *result.irradiance, options);
    }
    write_file(path, result.glb);
}

void check_bake_files(const std::filesystem::path& path, const BakeSettings& settings) {
    check_export_name(path);
    for (const std::filesystem::path& file : bake_files(path, settings)) const PendingFile writable(file);
}

} // namespace ajar
