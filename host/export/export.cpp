#include "export/export.hpp"

#include "base/error.hpp"
#include "base/file.hpp"
#include "export/materials.hpp"
#include "export/meshes.hpp"
#include "export/nodes.hpp"

#include <fmt/format.h>

namespace ajar {

namespace {

using namespace gltf_out;

}

std::vector<std::byte> glb_bytes(const Scene& scene, const ExportOptions& options) {
    validate(scene);
    Document document(options);
    document.root()["scene"] = 0;
    document.root()["scenes"] = Json::array({Json::object()});
    set_name(document.root()["scenes"][0], scene.name);
    add_textures(scene, document);
    add_materials(scene, document);
    const std::vector<std::uint32_t> meshes = add_meshes(scene, document);
    add_instances(scene, meshes, document);
    add_lights(scene, document);
    add_cameras(scene, document);
    if (scene.environment) document.warn("the environment is left out: glTF has no place for one");
    return document.glb();
}

void check_export_name(const std::filesystem::path& path) {
    if (path.extension() != ".glb")
        throw Error(fmt::format("{}: cannot be written: the extension '{}' is not .glb", path.string(),
                                path.extension().string()));
    const PendingFile checks_the_folder(path); // creates nothing
}

void export_gltf(const std::filesystem::path& path, const Scene& scene, const ExportOptions& options) {
    check_export_name(path);
    write_file(path, glb_bytes(scene, options));
}

} // namespace ajar
