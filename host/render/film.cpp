#include "render/film.hpp"

#include "base/error.hpp"
#include "shaders/shared/film.glsl.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <fmt/format.h>
#include <glm/glm.hpp>
#include <string>
#include <utility>

namespace ajar {

namespace {

using shared::AovPixel;
using shared::FilmPixel;

// Bits of the low half spread to even positions.
std::uint64_t spread(std::uint64_t x) {
    x = (x | (x << 16)) & 0x0000ffff0000ffffull;
    x = (x | (x << 8)) & 0x00ff00ff00ff00ffull;
    x = (x | (x << 4)) & 0x0f0f0f0f0f0f0f0full;
    x = (x | (x << 2)) & 0x3333333333333333ull;
    return (x | (x << 1)) & 0x5555555555555555ull;
}

// Fixed-point sums as numbers. long double keeps the 64 bits of a sum, so that constant pixels get variance
// zero.
long double radiance_sum(const FilmPixel& p, int channel) {
    return std::ldexp(std::ldexp(static_cast<long double>(p.sum[2 * channel + 1]), 32) + p.sum[2 * channel],
                      -28);
}

long double square_sum(const FilmPixel& p, int channel) {
    const std::uint32_t* w = p.square + 3 * channel;
    return std::ldexp(std::ldexp(static_cast<long double>(w[2]), 64) +
                          std::ldexp(static_cast<long double>(w[1]), 32) + w[0],
                      -44);
}

double aov_sum(const AovPixel& p, std::uint32_t channel) {
    const std::uint64_t bits = p.sum[2 * channel] | std::uint64_t{p.sum[2 * channel + 1]} << 32;
    return std::ldexp(static_cast<double>(std::bit_cast<std::int64_t>(bits)), -32);
}

Layer make_layer(std::string name, std::vector<std::string> channels, std::size_t pixels) {
    Layer layer;
    layer.name = std::move(name);
    layer.channels = static_cast<std::uint32_t>(channels.size());
    layer.channel_names = std::move(channels);
    layer.pixels.resize(pixels * layer.channels);
    return layer;
}

} // namespace

std::vector<std::uint32_t> morton_pixel_order(std::uint32_t width, std::uint32_t height) {
    if (width == 0 || height == 0 || width > 65535 || height > 65535)
        throw Error(fmt::format("image size {}x{}: each side must be 1 to 65535 pixels", width, height));
    std::vector<std::pair<std::uint64_t, std::uint32_t>> keyed;
    keyed.reserve(std::size_t{width} * height);
    for (std::uint32_t y = 0; y < height; ++y)
        for (std::uint32_t x = 0; x < width; ++x) keyed.emplace_back(spread(x) | spread(y) << 1, x | y << 16);
    std::sort(keyed.begin(), keyed.end());
    std::vector<std::uint32_t> order(keyed.size());
    for (std::size_t i = 0; i < keyed.size(); ++i) order[i] = keyed[i].second;
    return order;
}

FilmPixels FilmPixels::picture(std::uint32_t width, std::uint32_t height) {
    return {width, height, morton_pixel_order(width, height)};
}

FilmPixels FilmPixels::list(std::size_t count) {
    constexpr std::size_t MAX_WIDTH = 1u << 15;
    if (count > MAX_WIDTH * 65535) throw Error(fmt::format("{} surface elements: too many", count));
    FilmPixels pixels;
    pixels.width = static_cast<std::uint32_t>(std::clamp<std::size_t>(count, 1, MAX_WIDTH));
    pixels.height = static_cast<std::uint32_t>((count + pixels.width - 1) / pixels.width);
    for (std::uint32_t i = 0; i < count; ++i)
        pixels.order.push_back(i % pixels.width | i / pixels.width << 16);
    return pixels;
}

Film::Film(const gpu::Device& device, FilmPixels pixels, bool aovs)
    : width_(pixels.width), height_(pixels.height), order_(std::move(pixels.order)) {
    const std::uint64_t bindable = device.limits().max_storage_bytes / sizeof(FilmPixel);
    chunk_pixels_ = static_cast<std::uint32_t>(std::min<std::uint64_t>({order_.size(), bindable, 1u << 20}));
    order_buffer_ = gpu::Buffer(device, order_.size() * sizeof(std::uint32_t), "pixel order");
    order_buffer_.write(std::span<const std::uint32_t>(order_));
    for (std::size_t first = 0; first < order_.size(); first += chunk_pixels_) {
        const std::size_t count = std::min<std::size_t>(chunk_pixels_, order_.size() - first);
        chunks_.emplace_back(device, count * sizeof(FilmPixel), "film");
    }
    if (aovs) aov_buffer_ = gpu::Buffer(device, order_.size() * sizeof(AovPixel), "film of first hits");
}

std::uint64_t Film::device_bytes() const {
    std::uint64_t bytes = order_.size() * (sizeof(std::uint32_t) + sizeof(FilmPixel));
    if (aov_buffer_) bytes += order_.size() * sizeof(AovPixel);
    return bytes;
}

Image Film::resolve() const {
    Image image;
    image.width = width_;
    image.height = height_;
    resolve_radiance(image);
    if (aov_buffer_) resolve_aovs(image);
    return image;
}

void Film::resolve_radiance(Image& image) const {
    const std::size_t image_pixels = std::size_t{width_} * height_;
    Layer beauty = make_layer("", {"R", "G", "B", "A"}, image_pixels);
    Layer variance = make_layer("variance", {"R", "G", "B"}, image_pixels);
    Layer samples = make_layer("samples", {"N"}, image_pixels);
    std::size_t ordinal = 0;
    for (const gpu::Buffer& chunk : chunks_) {
        for (const FilmPixel& p : chunk.read<FilmPixel>(0, chunk.size_bytes() / sizeof(FilmPixel))) {
            const std::uint32_t packed = order_[ordinal++];
            const std::size_t at = std::size_t{packed >> 16} * width_ + (packed & 0xffffu);
            samples.pixels[at] = static_cast<float>(p.count);
            if (p.count == 0) continue;
            const long double n = p.count;
            for (int c = 0; c < 3; ++c) {
                const long double mean = radiance_sum(p, c) / n;
                const long double spread_about_mean = square_sum(p, c) / n - mean * mean;
                const long double of_mean =
                    p.count > 1 ? std::max(spread_about_mean, 0.0L) / (n - 1) : square_sum(p, c);
                beauty.pixels[4 * at + static_cast<std::size_t>(c)] = static_cast<float>(mean);
                variance.pixels[3 * at + static_cast<std::size_t>(c)] = static_cast<float>(of_mean);
            }
            beauty.pixels[4 * at + 3] = 1;
        }
    }
    image.layers.push_back(std::move(beauty));
    image.layers.push_back(std::move(variance));
    image.layers.push_back(std::move(samples));
}

void Film::resolve_aovs(Image& image) const {
    const std::size_t n = order_.size();
    Layer layers[] = {make_layer("albedo", {"R", "G", "B"}, n), make_layer("normal", {"X", "Y", "Z"}, n),
                      make_layer("position", {"X", "Y", "Z"}, n), make_layer("depth", {"Z"}, n),
                      make_layer("emission", {"R", "G", "B"}, n)};
    Layer object_id = make_layer("object_id", {"ID"}, n);
    Layer material_id = make_layer("material_id", {"ID"}, n);
    const std::vector<AovPixel> pixels = aov_buffer_.read<AovPixel>(0, n);
    for (std::size_t ordinal = 0; ordinal < n; ++ordinal) {
        const AovPixel& p = pixels[ordinal];
        const std::size_t at = std::size_t{order_[ordinal] >> 16} * width_ + (order_[ordinal] & 0xffffu);
        object_id.pixels[at] = static_cast<float>(p.object_id);
        material_id.pixels[at] = static_cast<float>(p.material_id);
        if (p.hits == 0) continue;
        std::uint32_t channel = 0;
        for (Layer& layer : layers)
            for (std::uint32_t c = 0; c < layer.channels; ++c)
                layer.pixels[at * layer.channels + c] = static_cast<float>(aov_sum(p, channel++) / p.hits);
        float* normal = &layers[1].pixels[at * 3];
        const float length = std::hypot(normal[0], normal[1], normal[2]);
        for (int c = 0; c < 3 && length > 0; ++c) normal[c] /= length;
    }
    for (Layer& layer : layers) image.layers.push_back(std::move(layer));
    image.layers.push_back(std::move(object_id));
    image.layers.push_back(std::move(material_id));
}

} // namespace ajar
