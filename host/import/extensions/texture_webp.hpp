// EXT_texture_webp: a texture whose image is WebP, perhaps beside a PNG or JPEG for programs that cannot read
// it.
#pragma once

#include "import/json.hpp"

namespace ajar::gltf {

// The extension's image, if the texture has one.
std::optional<std::uint32_t> webp_source(const JsonObject& texture, std::size_t image_count);

} // namespace ajar::gltf
