#include "ajar/manifest.hpp"

#include "ajar/radiosity_manifest.hpp"
#include "ajar/version.hpp"
#include "base/hash.hpp"
#include "gpu/kernel.hpp"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

namespace ajar {

namespace {

using Json = nlohmann::ordered_json;

std::string dump(const Json& json, int indent) {
    return json.dump(indent, ' ', false, Json::error_handler_t::replace); // names may hold invalid UTF-8
}

std::string filter_name(PixelFilter filter) { return pixel_filters()[static_cast<std::size_t>(filter)].name; }

// An index or the name given; otherwise the name, or the index, of the camera that the scene itself has
// chosen.
std::string camera_name(const Manifest& m) {
    if (!m.stats.settings.camera.empty()) return m.stats.settings.camera;
    if (m.scene.camera < m.scene.cameras.size() && !m.scene.cameras[m.scene.camera].name.empty())
        return m.scene.cameras[m.scene.camera].name;
    return std::to_string(m.scene.camera);
}

// Settings that make the mean differ from the truth.
Json biased_by(const RenderSettings& s) {
    Json reasons = Json::array();
    if (s.clamp > 0) reasons.push_back("clamp");
    if (s.integrator == "radiosity") reasons.push_back("radiosity"); // finite patches, diffuse surfaces
    return reasons;
}

Json image_settings(const Manifest& m) {
    const RenderSettings& s = m.stats.settings;
    return {{"width", s.width},
            {"height", s.height},
            {"first_sample", s.first_sample},
            {"samples", m.stats.samples},
            {"seed", s.seed},
            {"max_bounces", s.max_bounces},
            {"rr_depth", s.rr_depth},
            {"integrator", s.integrator},
            {"strategy", s.strategy},
            {"heuristic", s.heuristic},
            {"light_sampler", s.light_sampler},
            {"light_rays", s.light_rays},
            {"sampler", s.sampler},
            {"sequence_samples", s.sequence_samples},
            {"naive_sampling", s.naive_sampling},
            {"triangle_sampling", s.triangle_sampling},
            {"shading", s.shading},
            {"environment_sampling", s.environment_sampling},
            {"camera", camera_name(m)},
            {"filter", filter_name(s.filter)},
            {"filter_radius", s.filter_radius},
            {"background", {s.background[0], s.background[1], s.background[2]}},
            {"ao_distance", s.ao_distance},
            {"backfaces", s.cull_backfaces ? "cull" : "show"},
            {"clamp", s.clamp},
            {"biased_by", biased_by(s)},
            {"aovs", s.aovs}};
}

std::map<std::string, std::string> kernel_hashes() {
    std::map<std::string, std::string> hashes;
    for (const std::string& name : gpu::embedded_kernel_names())
        hashes[name] = gpu::embedded_kernel_hash(name);
    return hashes;
}

// One hash for all kernels.
std::string shader_hash() {
    std::string all;
    for (const auto& [name, hash] : kernel_hashes()) all += name + ' ' + hash + '\n';
    return content_hash(std::as_bytes(std::span(all.data(), all.size())));
}

Json scene_json(const Manifest& m) {
    Json json{{"file", m.scene_name}, {"hash", m.scene_hash}};
    json["triangles"] = m.stats.triangles;
    json["instances"] = m.scene.instances.size();
    json["lights"] = m.stats.lights;
    if (const auto& environment = m.scene.environment)
        json["environment"] = {{"name", environment->name},
                               {"width", environment->width},
                               {"height", environment->height},
                               {"scale", {environment->scale.x, environment->scale.y, environment->scale.z}},
                               {"rotation_degrees", glm::degrees(environment->rotation)}};
    return json;
}

Json device_json(const gpu::Device& device) {
    const gpu::DeviceDescription& d = device.description();
    return {{"name", d.name},
            {"driver", d.driver},
            {"kind", d.kind},
            {"vulkan", d.api_version},
            {"subgroup_size", device.limits().subgroup_size},
            {"workgroup_size", device.workgroup_size()},
            {"tables_by_pointers", device.options().force_pointers}};
}

Json time_json(const RenderStats& stats) {
    double total = 0;
    for (const auto& [name, time] : stats.profile) total += time.seconds;
    Json kernels = Json::object();
    for (const auto& [name, time] : stats.profile)
        kernels[name] = {{"seconds", time.seconds},
                         {"dispatches", time.dispatches},
                         {"share", total > 0 ? time.seconds / total : 0}};
    return {{"prepare_seconds", stats.prepare_seconds},       {"bvh_seconds", stats.bvh_seconds},
            {"light_tree_seconds", stats.light_tree_seconds}, {"render_seconds", stats.render_seconds},
            {"learning_seconds", stats.learning_seconds},     {"kernels", kernels}};
}

Json rays_json(const RenderStats& stats) {
    const auto all = static_cast<double>(stats.extension_rays + stats.shadow_rays);
    return {{"camera", stats.camera_rays},
            {"extension", stats.extension_rays},
            {"shadow", stats.shadow_rays},
            {"shadow_open", stats.shadow_rays_open},
            {"mrays_per_second", stats.render_seconds > 0 ? all / stats.render_seconds * 1e-6 : 0}};
}

} // namespace

std::vector<std::pair<std::string, std::string>> reproduction_metadata(const Manifest& m) {
    const gpu::DeviceDescription& d = m.device.description();
    Json settings = image_settings(m);
    if (m.radiosity != nullptr) settings["radiosity"] = radiosity_settings_json(*m.radiosity);
    if (m.stats.interrupted)
        settings["interrupted"] = true; // some pixels may have more samples: layer "samples"
    return {{"ajar:version", std::string(version())},
            {"ajar:settings", dump(settings, -1)},
            {"ajar:scene_hash", m.scene_hash},
            {"ajar:shader_hash", shader_hash()},
            {"ajar:device", d.name},
            {"ajar:driver", d.driver}};
}

std::string manifest_json(const Manifest& m) {
    Json json;
    json["ajar"] = {{"version", version()}, {"compiler", __VERSION__}};
    json["scene"] = scene_json(m);
    json["settings"] = image_settings(m);
    const RenderSettings& s = m.stats.settings;
    json["speed"] = {{"time_limit", s.time_limit},
                     {"pool_paths", s.pool_paths},
                     {"segment_paths", s.segment_paths},
                     {"slice_seconds", s.slice_seconds}};
    json["device"] = device_json(m.device);
    json["shaders"] = {{"hash", shader_hash()}, {"kernels", kernel_hashes()}};
    json["result"] = {{"samples", m.stats.samples},
                      {"samples_asked", m.stats.settings.samples},
                      {"interrupted", m.stats.interrupted},
                      {"out_of_time", m.stats.out_of_time},
                      {"invalid_samples", m.stats.invalid_samples},
                      {"saturated_samples", m.stats.saturated_samples},
                      {"exhausted_loops", m.stats.exhausted_loops},
                      {"device_bytes", m.stats.device_bytes}};
    if (m.radiosity != nullptr) json["radiosity"] = radiosity_json(*m.radiosity);
    json["time"] = time_json(m.stats);
    json["rays"] = rays_json(m.stats);
    return dump(json, 2) + "\n";
}

} // namespace ajar
