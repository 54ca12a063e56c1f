// The film on the device: exact fixed-point sums per pixel, in chunks that a device can bind, and its way to
// an Image.
#pragma once

#include "gpu/buffer.hpp"
#include "image/image.hpp"

#include <cstdint>
#include <vector>

namespace ajar {

// Pixels of a w x h image in Morton order (x | y << 16), so that paths that fly together start together.
// Throws Error above 65535 pixels a side.
std::vector<std::uint32_t> morton_pixel_order(std::uint32_t width, std::uint32_t height);

// Which pixels a film has, and in which order: a pixel's place in it is its ordinal.
struct FilmPixels {
    std::uint32_t width = 0; // of the image
    std::uint32_t height = 0;
    std::vector<std::uint32_t> order; // x | y << 16

    // The whole of a picture along the Morton curve.
    static FilmPixels picture(std::uint32_t width, std::uint32_t height);
    // So many in rows, for what is no picture: pixel i of the image is ordinal i. Throws Error beyond 2^31.
    static FilmPixels list(std::size_t count);
};

class Film {
  public:
    Film(const gpu::Device& device, FilmPixels pixels, bool aovs);

    std::uint32_t pixel_count() const { return static_cast<std::uint32_t>(order_.size()); }
    std::uint32_t chunk_pixels() const { return chunk_pixels_; } // the last chunk may hold fewer
    const std::vector<gpu::Buffer>& chunks() const { return chunks_; }
    const gpu::Buffer& pixel_order() const { return order_buffer_; }
    const gpu::Buffer& aovs() const { return aov_buffer_; }
    std::uint64_t device_bytes() const;

    // Layers "" (mean radiance; A = 1) and "variance" (of the mean; of a pixel with one sample: its square),
    // "samples", and the first-hit layers where the film has them. Pixels without samples are black with A =
    // 0.
    Image resolve() const;

  private:
    void resolve_radiance(Image& image) const;
    void resolve_aovs(Image& image) const;

    std::uint32_t width_;
    std::uint32_t height_;
    std::uint32_t chunk_pixels_;
    std::vector<std::uint32_t> order_;
    gpu::Buffer order_buffer_;
    std::vector<gpu::Buffer> chunks_;
    gpu::Buffer aov_buffer_;
};

} // namespace ajar
