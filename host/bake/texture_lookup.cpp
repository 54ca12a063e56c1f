#include "bake/texture_lookup.hpp"

#include "image/srgb.hpp"

#include <algorithm>
#include <cmath>

namespace ajar {

namespace {

// One axis: the two texels and the weight of the second.
struct Axis {
    std::uint32_t first, second;
    float weight;
};

std::uint32_t wrapped(std::int64_t i, std::int64_t size, Wrap wrap) {
    if (wrap == Wrap::clamp) return static_cast<std::uint32_t>(std::clamp<std::int64_t>(i, 0, size - 1));
    const std::int64_t period = wrap == Wrap::mirror ? 2 * size : size;
    const std::int64_t within = (i % period + period) % period;
    return static_cast<std::uint32_t>(within < size ? within : period - 1 - within);
}

Axis axis(float u, std::uint32_t size, Wrap wrap, TextureFilter filter) {
    if (!(std::abs(u) <= 0x1p20f)) u = 0; // as on the device: no bits are left within a repeat
    const bool nearest = filter == TextureFilter::nearest;
    const double x = static_cast<double>(u) * size - (nearest ? 0 : 0.5);
    const auto base = static_cast<std::int64_t>(std::floor(x));
    return {wrapped(base, size, wrap), wrapped(base + 1, size, wrap),
            nearest ? 0.0f : static_cast<float>(x - std::floor(x))};
}

} // namespace

TextureLookup::TextureLookup(const Scene& scene) : scene_(scene) {
    for (std::size_t i = 0; i < decode_.size(); ++i) decode_[i] = srgb_decode(static_cast<float>(i) / 255);
}

glm::vec4 TextureLookup::texel(const TextureImage& image, std::uint32_t x, std::uint32_t y) const {
    const std::uint8_t* rgba = &image.rgba[4 * (x + std::size_t{image.width} * y)];
    return {decode_[rgba[0]], decode_[rgba[1]], decode_[rgba[2]], static_cast<float>(rgba[3]) / 255};
}

glm::vec4 TextureLookup::color(const TextureUse& use, const glm::vec2& uv0, const glm::vec2& uv1) const {
    if (!use.used()) return glm::vec4(1);
    const Texture& texture = scene_.textures[use.texture];
    const TextureImage& image = scene_.images[texture.image];
    const glm::vec3 raw(use.uv_set == 1 ? uv1 : uv0, 1);
    const Axis u = axis(glm::dot(use.uv_row_u, raw), image.width, texture.wrap_u, texture.filter);
    const Axis v = axis(glm::dot(use.uv_row_v, raw), image.height, texture.wrap_v, texture.filter);
    const auto row = [&](std::uint32_t y) {
        return glm::mix(texel(image, u.first, y), texel(image, u.second, y), u.weight);
    };
    return glm::mix(row(v.first), row(v.second), v.weight);
}

} // namespace ajar
