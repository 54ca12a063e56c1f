// A picture to draw on: rectangles, frames, other pictures, and text in a small stroke font of its own, so
// that a sheet looks the same wherever it is made. Colours are sRGB-encoded, in [0, 1].
#pragma once

#include "image/image.hpp"
#include "image/tonemap.hpp"

#include <glm/glm.hpp>
#include <string_view>
#include <vector>

namespace ajar {

// In pixels, from the top left corner.
struct Region {
    std::uint32_t x = 0, y = 0, width = 0, height = 0;
};

// The width that `text` takes at a height of capitals in pixels. Known are ASCII's letters, digits and
// signs; any other character of UTF-8 takes the place of one.
float text_width(std::string_view text, float capitals);

class Canvas {
  public:
    Canvas(std::uint32_t width, std::uint32_t height, const glm::vec3& background);

    // What lies outside of the canvas is left out.
    void fill(const Region& region, const glm::vec3& color);
    // A frame of that thickness just inside of the region.
    void frame(const Region& region, std::uint32_t thickness, const glm::vec3& color);
    // x: left end; y: the line that capitals stand on.
    void text(float x, float y, std::string_view text, float capitals, const glm::vec3& color);
    // The part `from` of a picture, tone-mapped, over the region `to`: larger by repeating pixels, smaller
    // by averaging what is shown of them.
    void picture(const Region& to, const Image& image, const Region& from, const Tonemap& tonemap);

    // For write_image with the operator "linear".
    Image image() const;

  private:
    void stroke(const glm::vec2& a, const glm::vec2& b, float radius, const glm::vec3& color);
    glm::vec3* at(std::uint32_t x, std::uint32_t y) { return &pixels_[std::size_t{y} * width_ + x]; }

    std::uint32_t width_, height_;
    std::vector<glm::vec3> pixels_;
};

} // namespace ajar
