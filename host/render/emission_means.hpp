// How much a triangle with an emission texture emits on average, to decide how often it is sampled.
// Importance only: the kernels look the texture up at each sampled point, so an error here costs noise, not
// truth, as long as a triangle that emits anywhere does not get 0.
#pragma once

#include "scene/scene.hpp"

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <map>
#include <vector>

namespace ajar {

class EmissionMeans {
  public:
    // `scene` must outlive this.
    explicit EmissionMeans(const Scene& scene);

    // Mean radiance of a material over a triangle with these texture coordinates (of the set that its
    // emission texture uses; any where there is none). At least 1/64 of the largest texel that the triangle
    // can show; 0 exactly where it shows none that emits. May be called from many threads.
    glm::vec3 mean(std::uint32_t material, const std::array<glm::vec2, 3>& uv) const;

  private:
    // Level k of the maxima: cells of 2^k x 2^k texels, largest of each channel.
    struct Level {
        std::uint32_t width = 0;
        std::uint32_t height = 0;
        std::vector<std::array<std::uint8_t, 3>> cells;
    };
    using Pyramid = std::vector<Level>;

    static Pyramid build_pyramid(const TextureImage& image);
    glm::vec3 footprint_max(const Texture& texture, const std::array<glm::dvec2, 3>& texels) const;
    glm::vec3 sampled_mean(const Texture& texture, const std::array<glm::dvec2, 3>& texels) const;

    const Scene& scene_;
    std::array<float, 256> decode_{};           // sRGB to linear
    std::map<std::uint32_t, Pyramid> pyramids_; // by Scene::images index
};

} // namespace ajar
