#include "image/canvas.hpp"

#include "image/srgb.hpp"
#include "image/stroke_font.hpp"

#include <algorithm>
#include <cmath>

namespace ajar {
namespace {

// Half a stroke's width in grid steps: an eighth of a capital's height a stroke, as in text faces.
constexpr float STROKE_RADIUS = 0.38f;

// One byte for each character: what is not ASCII becomes one byte that the font shows as a box.
std::string ascii(std::string_view text) {
    std::string out;
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if ((byte & 0xc0u) != 0x80u) out += byte < 0x80 ? c : '\x7f';
    }
    return out;
}

float advance(char c) { return glyph_width(c) + STROKE_FONT_GAP; }

// Of column or row `i` of `size` shown pixels: the source's first and the one after its last.
std::pair<std::uint32_t, std::uint32_t> sources(std::uint32_t i, std::uint32_t size, std::uint32_t from,
                                                std::uint32_t count) {
    const auto place = [&](std::uint32_t k) {
        return static_cast<std::uint32_t>(std::uint64_t{k} * count / size);
    };
    return {from + place(i), from + std::max(place(i + 1), place(i) + 1)};
}

} // namespace

float text_width(std::string_view text, float capitals) {
    float steps = 0;
    for (const char c : ascii(text)) steps += advance(c);
    return std::max(steps - STROKE_FONT_GAP, 0.0f) * capitals / STROKE_FONT_CAPITALS;
}

Canvas::Canvas(std::uint32_t width, std::uint32_t height, const glm::vec3& background)
    : width_(width), height_(height), pixels_(std::size_t{width} * height, background) {}

void Canvas::fill(const Region& r, const glm::vec3& color) {
    const std::uint32_t right = std::min(r.x + r.width, width_), bottom = std::min(r.y + r.height, height_);
    for (std::uint32_t y = r.y; y < bottom; ++y)
        for (std::uint32_t x = r.x; x < right; ++x) *at(x, y) = color;
}

void Canvas::frame(const Region& r, std::uint32_t thickness, const glm::vec3& color) {
    const std::uint32_t t = std::min({thickness, r.width, r.height});
    fill({r.x, r.y, r.width, t}, color);
    fill({r.x, r.y + r.height - t, r.width, t}, color);
    fill({r.x, r.y, t, r.height}, color);
    fill({r.x + r.width - t, r.y, t, r.height}, color);
}

// Blends by how much of each pixel lies nearer than `radius` to the line from a to b.
void Canvas::stroke(const glm::vec2& a, const glm::vec2& b, float radius, const glm::vec3& color) {
    const glm::vec2 low = glm::min(a, b) - radius - 1.0f, high = glm::max(a, b) + radius + 1.0f;
    const auto clamped = [](float value, std::uint32_t size) {
        return static_cast<std::uint32_t>(std::clamp(value, 0.0f, static_cast<float>(size)));
    };
    const glm::vec2 along = b - a;
    const float square = glm::dot(along, along);
    for (std::uint32_t y = clamped(low.y, height_); y < clamped(high.y, height_); ++y)
        for (std::uint32_t x = clamped(low.x, width_); x < clamped(high.x, width_); ++x) {
            const glm::vec2 p(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
            const float t = square > 0 ? std::clamp(glm::dot(p - a, along) / square, 0.0f, 1.0f) : 0.0f;
            const float cover = std::clamp(0.5f + radius - glm::length(p - a - t * along), 0.0f, 1.0f);
            *at(x, y) = glm::mix(*at(x, y), color, cover);
        }
}

void Canvas::text(float x, float y, std::string_view text, float capitals, const glm::vec3& color) {
    const float step = capitals / STROKE_FONT_CAPITALS;
    for (const char c : ascii(text)) {
        const std::string_view strokes = glyph_strokes(c);
        const auto point = [&](std::size_t i) {
            return glm::vec2(x + step * static_cast<float>(strokes[i] - '0'),
                             y - capitals + step * static_cast<float>(strokes[i + 1] - '0'));
        };
        for (std::size_t i = 0; i + 3 < strokes.size();) {
            stroke(point(i), point(i + 2), STROKE_RADIUS * step, color);
            i += 2;
            if (i + 2 < strokes.size() && strokes[i + 2] == ' ') i += 3;
        }
        x += step * advance(c);
    }
}

void Canvas::picture(const Region& to, const Image& image, const Region& from, const Tonemap& tonemap) {
    const Layer& layer = beauty(image, "picture");
    for (std::uint32_t j = 0; j < to.height && to.y + j < height_; ++j)
        for (std::uint32_t i = 0; i < to.width && to.x + i < width_; ++i) {
            const auto [left, right] = sources(i, to.width, from.x, from.width);
            const auto [top, bottom] = sources(j, to.height, from.y, from.height);
            glm::vec3 sum(0);
            for (std::uint32_t y = top; y < bottom; ++y)
                for (std::uint32_t x = left; x < right; ++x) {
                    const float* p =
                        layer.pixels.data() + (std::size_t{y} * image.width + x) * layer.channels;
                    sum += srgb_decode(tonemap(glm::vec3(p[0], p[1], p[2])));
                }
            *at(to.x + i, to.y + j) = srgb_encode(sum / static_cast<float>((right - left) * (bottom - top)));
        }
}

Image Canvas::image() const {
    Image image{width_, height_, {}, {}, Range::display};
    Layer& layer = image.add("", {"R", "G", "B", "A"});
    for (std::size_t i = 0; i < pixels_.size(); ++i) {
        const glm::vec3 color = srgb_decode(pixels_[i]);
        for (std::size_t c = 0; c < 3; ++c) layer.pixels[4 * i + c] = color[static_cast<int>(c)];
        layer.pixels[4 * i + 3] = 1;
    }
    return image;
}

} // namespace ajar
