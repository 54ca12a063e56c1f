// Textures, samplers and images (glTF 2.0, section 3.8). Only those that a material uses reach the scene.
#pragma once

#include "import/buffers.hpp"
#include "scene/scene.hpp"

#include <unordered_map>

namespace ajar::gltf {

class Textures {
  public:
    Textures(Document& document, Buffers& buffers, Scene& scene);

    // The use that a textureInfo describes; unused where `texture_info` is missing or its texture has no
    // image.
    TextureUse use(const std::optional<JsonObject>& texture_info);

  private:
    std::uint32_t texture(std::uint32_t index);
    std::uint32_t image(std::uint32_t index);
    void read_sampler(const JsonObject& texture, Texture& result);

    Document& document_;
    Buffers& buffers_;
    Scene& scene_;
    std::vector<JsonObject> textures_;
    std::vector<JsonObject> images_;
    std::vector<JsonObject> samplers_;
    std::unordered_map<std::uint32_t, std::uint32_t> scene_textures_; // glTF index -> Scene index or NO_INDEX
    std::unordered_map<std::uint32_t, std::uint32_t> scene_images_;
};

} // namespace ajar::gltf
