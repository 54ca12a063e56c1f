// Environment maps: the image room reads the file, this gives it its place in a scene.
#include "image/read.hpp"
#include "import/import.hpp"

namespace ajar {

Environment import_environment(const std::filesystem::path& path) {
    EnvironmentImage image = read_environment(path);
    Environment environment;
    environment.name = path.filename().string();
    environment.width = image.width;
    environment.height = image.height;
    environment.radiance = std::move(image.radiance);
    return environment;
}

} // namespace ajar
