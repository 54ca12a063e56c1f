// Textures filtered on the host as the device filters them (shaders/material/texture.glsl).
#pragma once

#include "scene/scene.hpp"

#include <array>

namespace ajar {

class TextureLookup {
  public:
    // `scene` must outlive this.
    explicit TextureLookup(const Scene& scene);

    // Of an sRGB texture, decoded; alpha as it is. White where nothing is used.
    glm::vec4 color(const TextureUse& use, const glm::vec2& uv0, const glm::vec2& uv1) const;

  private:
    glm::vec4 texel(const TextureImage& image, std::uint32_t x, std::uint32_t y) const;

    const Scene& scene_;
    std::array<float, 256> decode_{}; // sRGB to linear
};

} // namespace ajar
