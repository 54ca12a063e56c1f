#include "ajar/radiosity_manifest.hpp"

#include <nlohmann/json.hpp>

namespace ajar {

namespace {

using Json = nlohmann::ordered_json;

Json history_json(const std::vector<RadiosityIteration>& history) {
    Json rows = Json::array();
    for (const RadiosityIteration& i : history)
        rows.push_back({{"mesh", i.mesh},
                        {"iteration", i.iteration},
                        {"rows", i.rows},
                        {"residual", i.residual},
                        {"residual_power", i.residual_power},
                        {"error", i.error},
                        {"power", i.power}});
    return rows;
}

} // namespace

nlohmann::ordered_json radiosity_settings_json(const RadiosityResult& result) {
    const RadiositySettings& s = result.stats.settings;
    Json json{{"patch_size", s.patches.patch_size},
              {"patches", s.patches.patches},
              {"refine", s.refine},
              {"refine_threshold", s.refine_threshold},
              {"solver", s.solver},
              {"direct", s.direct},
              {"rays", s.rays},
              {"shadow_samples", s.shadow_samples},
              {"tolerance", s.tolerance},
              {"max_iterations", s.max_iterations},
              {"seed", s.render.seed},
              {"strategy", s.render.strategy},
              {"light_sampler", s.render.light_sampler},
              {"sampler", s.render.sampler}};
    if (result.stats.interrupted) json["interrupted_after"] = result.stats.iterations;
    return json;
}

nlohmann::ordered_json radiosity_json(const RadiosityResult& result) {
    const RadiosityStats& s = result.stats;
    Json json;
    json["settings"] = radiosity_settings_json(result);
    json["settings"]["memory_bytes"] = s.settings.memory_bytes;
    json["converged"] = s.converged;
    json["interrupted"] = s.interrupted;
    json["iterations"] = s.iterations;
    json["patches"] = s.patches;
    json["rows"] = {{"count", s.sides},         {"stored", s.rows_stored},
                    {"bytes", s.row_bytes},     {"rays", s.form_factor_rays},
                    {"sky_share", s.sky_share}, {"nowhere_share", s.nowhere_share}};
    json["reciprocity"] = {{"rms", s.reciprocity_rms},
                           {"rms_expected", s.reciprocity_expected},
                           {"max", s.reciprocity_max},
                           {"pairs", s.reciprocity_pairs}};
    json["power"] = {{"in", s.power_in}, {"absorbed", s.power_absorbed}, {"escaped", s.power_escaped}};
    json["time"] = {{"prepare_seconds", s.prepare_seconds},
                    {"material_seconds", s.material_seconds},
                    {"form_factor_seconds", s.form_factor_seconds},
                    {"direct_seconds", s.direct_seconds},
                    {"solve_seconds", s.solve_seconds}};
    json["device_bytes"] = s.device_bytes;
    json["exhausted_loops"] = s.exhausted_loops;
    json["invalid_samples"] = s.invalid_samples;
    json["history"] = history_json(result.history);
    return json;
}

} // namespace ajar
