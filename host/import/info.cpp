#include "import/info.hpp"

#include "import/extensions/table.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <iterator>
#include <nlohmann/json.hpp>

namespace ajar {

namespace {

// Sums over the instances, as a ray sees them, and over the meshes, as memory does.
struct Totals {
    std::uint64_t triangles = 0, placed_triangles = 0, vertices = 0;
};

Totals totals(const Scene& scene) {
    Totals t;
    for (const Mesh& mesh : scene.meshes)
        t.triangles += mesh.triangles.size(), t.vertices += mesh.positions.size();
    for (const Instance& instance : scene.instances)
        t.placed_triangles += scene.meshes[instance.mesh].triangles.size();
    return t;
}

std::string size_text(std::uint64_t bytes) {
    if (bytes < 1024) return fmt::format("{} bytes", bytes);
    if (bytes < 1024 * 1024) return fmt::format("{:.1f} KiB", static_cast<double>(bytes) / 1024);
    return fmt::format("{:.1f} MiB", static_cast<double>(bytes) / (1024 * 1024));
}

std::string_view to_string(CameraKind kind) {
    return kind == CameraKind::perspective ? "perspective" : "orthographic";
}

std::string_view to_string(LightKind kind) {
    switch (kind) {
    case LightKind::point: return "point";
    case LightKind::spot: return "spot";
    default: return "directional";
    }
}

std::string extent_text(const Light& light) {
    if (light.kind == LightKind::directional && light.angular_diameter > 0)
        return fmt::format(", {:.3g} degrees across", glm::degrees(light.angular_diameter));
    return light.radius > 0 ? fmt::format(", radius {:.3g} m", light.radius) : std::string();
}

nlohmann::json to_json(const glm::vec3& v) { return {v.x, v.y, v.z}; }

// Names come from the file; a line is a line.
std::string shown(const std::string& name) {
    std::string result = name.empty() ? "(unnamed)" : name;
    std::replace_if(
        result.begin(), result.end(), [](char c) { return static_cast<unsigned char>(c) < ' '; }, ' ');
    return result;
}

nlohmann::json file_json(const AssetInfo& info) {
    nlohmann::json extensions = nlohmann::json::array();
    for (const ExtensionUse& use : info.extensions)
        extensions.push_back(
            {{"name", use.name}, {"required", use.required}, {"support", to_string(use.support)}});
    return {{"name", info.file},           {"bytes", info.bytes_read},    {"gltf_version", info.version},
            {"generator", info.generator}, {"copyright", info.copyright}, {"scenes", info.scene_names},
            {"nodes", info.nodes},         {"meshes", info.meshes},       {"primitives", info.primitives},
            {"materials", info.materials}, {"textures", info.textures},   {"images", info.images},
            {"cameras", info.cameras},     {"lights", info.lights},       {"animations", info.animations},
            {"skins", info.skins},         {"extensions", extensions}};
}

nlohmann::json camera_json(const Camera& camera) {
    nlohmann::json json{{"name", camera.name},
                        {"kind", to_string(camera.kind)},
                        {"position", to_json(glm::vec3(camera.to_world[3]))}};
    if (camera.kind == CameraKind::perspective)
        json["yfov_degrees"] = glm::degrees(camera.yfov);
    else
        json["ymag"] = camera.ymag;
    return json;
}

nlohmann::json scene_json(const Scene& scene, const AssetInfo& info) {
    const Totals t = totals(scene);
    const Bounds bounds = scene_bounds(scene);
    nlohmann::json json{{"index", info.scene},
                        {"name", scene.name},
                        {"instances", scene.instances.size()},
                        {"meshes", scene.meshes.size()},
                        {"triangles", t.triangles},
                        {"placed_triangles", t.placed_triangles},
                        {"vertices", t.vertices},
                        {"skipped_primitives", info.skipped_primitives},
                        {"materials", scene.materials.size()},
                        {"textures", scene.textures.size()},
                        {"images", scene.images.size()},
                        {"automatic_camera", info.automatic_camera},
                        {"has_light", has_light(scene)},
                        {"memory_bytes", memory_bytes(scene)},
                        {"cameras", nlohmann::json::array()},
                        {"lights", nlohmann::json::array()},
                        {"bounds", nullptr}};
    if (!bounds.empty())
        json["bounds"] = {{"lower", to_json(bounds.lower)}, {"upper", to_json(bounds.upper)}};
    for (const Camera& camera : scene.cameras) json["cameras"].push_back(camera_json(camera));
    for (const Light& light : scene.lights)
        json["lights"].push_back({{"name", light.name},
                                  {"kind", to_string(light.kind)},
                                  {"intensity", to_json(light.intensity)},
                                  {"radius", light.radius},
                                  {"angular_diameter_degrees", glm::degrees(light.angular_diameter)}});
    for (const Instance& instance : scene.instances)
        if (instance.sphere_radius > 0)
            json["lights"].push_back({{"name", instance.name},
                                      {"kind", "sphere"},
                                      {"radius", instance.sphere_radius},
                                      {"position", to_json(instance.sphere_center)}});
    return json;
}

void append_extensions(const AssetInfo& info, std::string& text) {
    for (const ExtensionUse& use : info.extensions)
        fmt::format_to(std::back_inserter(text), "extension    {} ({}{})\n", shown(use.name),
                       to_string(use.support), use.required ? ", required" : "");
}

} // namespace

std::string_view to_string(ExtensionSupport support) {
    switch (support) {
    case ExtensionSupport::supported: return "supported";
    case ExtensionSupport::approximated: return "approximated";
    default: return "ignored";
    }
}

std::vector<KnownExtension> known_extensions() {
    std::vector<KnownExtension> known;
    for (const gltf::Extension& row : gltf::extension_table())
        known.push_back({row.name, row.support, row.help});
    return known;
}

std::string info_text(const ImportResult& result) {
    const auto& [scene, info] = result;
    const Totals t = totals(scene);
    const Bounds b = scene_bounds(scene);
    std::string text;
    const auto line = [&](std::string_view title, const std::string& value) {
        fmt::format_to(std::back_inserter(text), "{:<12} {}\n", title, value);
    };
    line("file", fmt::format("{} (glTF {}, {})", info.file, shown(info.version), size_text(info.bytes_read)));
    if (!info.generator.empty()) line("generator", shown(info.generator));
    if (!info.copyright.empty()) line("copyright", shown(info.copyright));
    for (std::size_t i = 0; i < info.scene_names.size(); ++i)
        line("scene",
             fmt::format("{} {}{}", i, shown(info.scene_names[i]), i == info.scene ? " (this one)" : ""));
    line("nodes",
         fmt::format("{}, {} of them with triangles of this scene", info.nodes, scene.instances.size()));
    line("meshes", fmt::format("{} of {}", scene.meshes.size(), info.meshes));
    line("triangles",
         fmt::format("{}, {} as placed; {} vertices", t.triangles, t.placed_triangles, t.vertices));
    line("materials", fmt::format("{}", info.materials));
    line("textures", fmt::format("{} of {}, from {} of {} images", scene.textures.size(), info.textures,
                                 scene.images.size(), info.images));
    for (const Light& light : scene.lights)
        line("light", fmt::format("{} ({}{})", shown(light.name), to_string(light.kind), extent_text(light)));
    for (const Instance& instance : scene.instances)
        if (instance.sphere_radius > 0)
            line("light", fmt::format("{} (mesh as a sphere, radius {:.3g} m)", shown(instance.name),
                                      instance.sphere_radius));
    if (!has_light(scene)) line("light", "none");
    for (const Camera& camera : scene.cameras)
        line("camera", fmt::format("{} ({})", shown(camera.name), to_string(camera.kind)));
    if (info.animations != 0) line("animations", fmt::format("{}, not played", info.animations));
    if (!b.empty())
        line("bounds", fmt::format("({:.5g}, {:.5g}, {:.5g}) to ({:.5g}, {:.5g}, {:.5g}) m", b.lower.x,
                                   b.lower.y, b.lower.z, b.upper.x, b.upper.y, b.upper.z));
    append_extensions(info, text);
    line("memory", size_text(memory_bytes(scene)));
    return text;
}

nlohmann::json info_json(const ImportResult& result) {
    return {{"file", file_json(result.info)},
            {"scene", scene_json(result.scene, result.info)},
            {"warnings", result.info.warnings}};
}

} // namespace ajar
