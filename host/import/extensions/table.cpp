#include "import/extensions/table.hpp"

#include "base/error.hpp"
#include "import/extensions/materials.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace ajar::gltf {

namespace {

using enum ExtensionSupport;

constexpr Extension TABLE[] = {
    {"EXT_meshopt_compression", supported, "compressed buffer views (meshoptimizer)"},
    {"EXT_texture_webp", supported, "WebP images"},
    {"KHR_draco_mesh_compression", supported, "compressed primitives (Draco)"},
    {"KHR_lights_punctual", supported, "point, spot and directional lights"},
    {"KHR_materials_emissive_strength", supported, "emission beyond 1", read_emissive_strength},
    {"KHR_materials_ior", supported, "index of refraction of dielectrics", read_ior},
    {"KHR_materials_pbrSpecularGlossiness", approximated,
     "diffuse colour as base colour, roughness = 1 - glossiness factor; the specular colour is ignored",
     read_specular_glossiness},
    {"KHR_materials_specular", supported,
     "strength and tint of dielectric reflection (factors, not textures)", read_specular},
    {"KHR_materials_unlit", supported, "base colour without lighting", read_unlit},
    {"KHR_mesh_quantization", supported, "vertex attributes of 8 and 16 bits"},
    {"KHR_meshopt_compression", supported, "compressed buffer views, streams of version 0"},
    {"KHR_texture_transform", supported, "offset, rotation and scale of texture coordinates"},
};

std::string join(const std::vector<std::string>& names) {
    std::string line;
    for (const std::string& name : names) line += (line.empty() ? "" : ", ") + name;
    return line;
}

} // namespace

std::span<const Extension> extension_table() { return TABLE; }

ExtensionSupport extension_support(std::string_view name) {
    const auto row =
        std::find_if(std::begin(TABLE), std::end(TABLE), [&](const Extension& e) { return e.name == name; });
    return row == std::end(TABLE) ? ignored : row->support;
}

void check_extensions(Document& document) {
    std::vector<std::string> used = document.root().texts("extensionsUsed");
    const std::vector<std::string> required = document.root().texts("extensionsRequired");
    used.insert(used.end(), required.begin(), required.end());
    std::sort(used.begin(), used.end());
    used.erase(std::unique(used.begin(), used.end()), used.end());
    std::vector<std::string> unknown, without;
    for (const std::string& name : used) {
        ExtensionUse use{name, std::find(required.begin(), required.end(), name) != required.end(),
                         extension_support(name)};
        if (use.required && use.support != supported) unknown.push_back(name);
        if (use.support == ignored) without.push_back(name);
        if (use.support == approximated) document.warn(fmt::format("{} is approximated", name));
        document.info().extensions.push_back(std::move(use));
    }
    if (!unknown.empty())
        throw Error(fmt::format("{}: requires {}, which this program does not know (export without it)",
                                document.file(), join(unknown)));
    if (!without.empty()) document.warn(fmt::format("ignored extensions: {}", join(without)));
}

} // namespace ajar::gltf
