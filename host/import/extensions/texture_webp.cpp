#include "import/extensions/texture_webp.hpp"

namespace ajar::gltf {

std::optional<std::uint32_t> webp_source(const JsonObject& texture, std::size_t image_count) {
    const auto extension = texture.extension("EXT_texture_webp");
    return extension ? extension->index("source", image_count, "image") : std::nullopt;
}

} // namespace ajar::gltf
