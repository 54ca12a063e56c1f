#include "ajar/scene_file.hpp"

#include "ajar/scene_hash.hpp"
#include "base/error.hpp"
#include "import/import.hpp"
#include "scene/default_environment.hpp"
#include "scene/scene.hpp"

#include <cmath>
#include <fmt/format.h>

namespace ajar {

struct SceneFile::Impl {
    std::string name;
    Scene scene;
    bool has_camera = false;
};

SceneFile::SceneFile(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
SceneFile::~SceneFile() = default;
SceneFile::SceneFile(SceneFile&&) noexcept = default;
SceneFile& SceneFile::operator=(SceneFile&&) noexcept = default;

SceneFile SceneFile::load(const std::filesystem::path& path, const LoadOptions& options) {
    ImportOptions import;
    import.warn = options.warn;
    import.scene = options.scene;
    import.aspect = options.aspect;
    auto impl = std::make_unique<Impl>();
    impl->name = path.filename().string();
    ImportResult result = import_gltf(path, import);
    impl->scene = std::move(result.scene);
    impl->has_camera = !result.info.automatic_camera;
    return SceneFile(std::move(impl));
}

void SceneFile::set_environment(const std::filesystem::path& map, const EnvironmentOptions& options) {
    if (!std::isfinite(options.strength) || options.strength < 0 || !std::isfinite(options.rotation_degrees))
        throw Error(fmt::format("{}: an environment's strength must be at least 0 and its rotation finite",
                                map.string()));
    Environment& environment = impl_->scene.environment.emplace(import_environment(map));
    environment.scale = glm::vec3(options.strength);
    environment.rotation = glm::radians(options.rotation_degrees);
}

void SceneFile::set_environment(float red, float green, float blue) {
    const glm::vec3 radiance(red, green, blue);
    if (!(glm::all(glm::greaterThanEqual(radiance, glm::vec3(0))) && std::isfinite(red + green + blue)))
        throw Error("environment: its radiance must be at least 0 and finite");
    Environment& environment = impl_->scene.environment.emplace();
    environment.name = "constant";
    environment.scale = radiance;
}

void SceneFile::set_default_environment() { impl_->scene.environment = default_environment(); }

bool SceneFile::has_light() const { return ajar::has_light(impl_->scene); }

bool SceneFile::has_camera() const { return impl_->has_camera; }

std::uint64_t SceneFile::triangle_count() const {
    std::uint64_t count = 0;
    for (const Instance& instance : impl_->scene.instances)
        count += impl_->scene.meshes[instance.mesh].triangles.size();
    return count;
}

const std::string& SceneFile::name() const { return impl_->name; }
std::string SceneFile::hash() const { return scene_hash(impl_->scene); }
const Scene& SceneFile::scene() const { return impl_->scene; }

} // namespace ajar
