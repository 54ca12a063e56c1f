// Small images for the tests of this folder.
#pragma once

#include "image/image.hpp"

#include <cstdint>
#include <functional>
#include <glm/glm.hpp>

namespace ajar::test {

inline Image make_image(std::uint32_t width, std::uint32_t height,
                        const std::function<glm::vec3(std::uint32_t, std::uint32_t)>& color) {
    Image image{width, height, {}, {}, Range::scene};
    Layer& layer = image.add("", {"R", "G", "B", "A"});
    for (std::uint32_t y = 0; y < height; ++y)
        for (std::uint32_t x = 0; x < width; ++x) {
            const glm::vec3 c = color(x, y);
            const std::size_t at = 4 * (std::size_t{y} * width + x);
            layer.pixels[at] = c.x, layer.pixels[at + 1] = c.y, layer.pixels[at + 2] = c.z,
            layer.pixels[at + 3] = 1;
        }
    return image;
}

inline Image flat(std::uint32_t width, std::uint32_t height, const glm::vec3& color) {
    return make_image(width, height, [&](std::uint32_t, std::uint32_t) { return color; });
}

} // namespace ajar::test
