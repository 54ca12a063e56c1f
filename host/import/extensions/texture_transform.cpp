#include "import/extensions/texture_transform.hpp"

#include <cmath>

namespace ajar::gltf {

void read_texture_transform(const JsonObject& texture_info, TextureUse& use) {
    const auto extension = texture_info.extension("KHR_texture_transform");
    if (!extension) return;
    const glm::vec2 offset = extension->vector<2>("offset", glm::vec2(0));
    const glm::vec2 scale = extension->vector<2>("scale", glm::vec2(1));
    const float angle = extension->number("rotation", 0);
    use.uv_set = static_cast<std::uint32_t>(extension->integer("texCoord", use.uv_set));
    // Translation * rotation * scale. The rotation is counter-clockwise as seen on a texture whose v grows
    // downwards.
    const float c = std::cos(angle);
    const float s = std::sin(angle);
    use.uv_row_u = {c * scale.x, s * scale.y, offset.x};
    use.uv_row_v = {-s * scale.x, c * scale.y, offset.y};
}

} // namespace ajar::gltf
