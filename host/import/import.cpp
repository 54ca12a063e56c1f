#include "import/import.hpp"

#include "base/error.hpp"
#include "base/file.hpp"
#include "import/cameras.hpp"
#include "import/extensions/lights_punctual.hpp"
#include "import/extensions/table.hpp"
#include "import/meshes.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <new>
#include <stdexcept>

namespace ajar {

namespace {

using namespace gltf;

ImportResult read(Document& document) {
    ImportResult result;
    Scene& scene = result.scene;
    check_extensions(document);
    const Nodes nodes(document);
    Buffers buffers(document);
    Accessors accessors(document, buffers);
    Textures textures(document, buffers, scene);
    const std::vector<bool> used = materials_in_scene(document, meshes_in_scene(document, nodes));
    read_materials(document, textures, used, scene);
    Meshes meshes(document, buffers, accessors, nodes, scene);
    for (const std::uint32_t node : nodes.in_scene()) meshes.add_instance(node);
    add_punctual_lights(document, nodes, scene);
    add_cameras(document, nodes, scene);
    scene.name = nodes.scene_name();
    if (scene.instances.empty()) document.warn("the scene has no triangles");
    AssetInfo& info = document.info();
    info.materials = document.count("materials");
    info.textures = document.count("textures");
    info.images = document.count("images");
    info.animations = document.count("animations");
    info.skins = document.count("skins");
    try {
        validate(scene);
    } catch (const Error& error) {
        throw Error(fmt::format("{}: {}", document.file(), error.what()));
    }
    result.info = info;
    return result;
}

// Names out of a hostile file may hold line breaks; an error is one line.
std::string one_line(std::string text) {
    std::replace_if(
        text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < ' '; }, ' ');
    return text;
}

ImportResult import_bytes(std::span<const std::byte> bytes, const std::string& file,
                          const std::filesystem::path& folder, const ImportOptions& options) {
    try {
        Document document(bytes, file, folder, options);
        return read(document);
    } catch (const Error& error) {
        throw Error(one_line(error.what()));
    } catch (const std::bad_alloc&) {
        throw Error(fmt::format("{}: there is not enough memory for this file", file));
    } catch (const std::length_error&) {
        throw Error(fmt::format("{}: a part of this file is too large for memory", file));
    }
}

} // namespace

ImportResult import_gltf(const std::filesystem::path& path, const ImportOptions& options) {
    const std::vector<std::byte> bytes = read_file(path, options.limits.max_file_bytes);
    const std::filesystem::path folder =
        path.has_parent_path() ? path.parent_path() : std::filesystem::path(".");
    return import_bytes(bytes, path.string(), folder, options);
}

ImportResult import_gltf_memory(std::span<const std::byte> bytes, const std::filesystem::path& base_folder,
                                const ImportOptions& options) {
    return import_bytes(bytes, "glTF in memory", base_folder, options);
}

} // namespace ajar
