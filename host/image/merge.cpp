#include "image/merge.hpp"

#include "base/error.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace ajar {

void SampleMean::add(const Image& image, std::uint64_t samples) {
    const Layer& mean = beauty(image, "merged image");
    const Layer* variance = image.find("variance");
    if (!variance || variance->channels < 3 ||
        variance->pixels.size() != image.pixel_count() * variance->channels)
        throw Error("merged image: has no layer 'variance' with R, G, B");
    if (samples_ == 0) {
        width_ = image.width, height_ = image.height;
        sums_.assign(image.pixel_count() * 3, 0);
        squares_.assign(image.pixel_count() * 3, 0);
    }
    if (image.width != width_ || image.height != height_)
        throw Error(fmt::format("merged image: is {} x {} pixels, others are {} x {}", image.width,
                                image.height, width_, height_));
    const auto n = static_cast<double>(samples);
    for (std::size_t i = 0; i < image.pixel_count(); ++i)
        for (std::size_t c = 0; c < 3; ++c) {
            const double m = mean.pixels[i * mean.channels + c];
            const double v = variance->pixels[i * variance->channels + c];
            sums_[3 * i + c] += n * m;
            squares_[3 * i + c] += n * ((n - 1) * v + m * m);
        }
    samples_ += samples;
}

Image SampleMean::image() const {
    Image image{width_, height_, {}, {}, Range::scene};
    image.add("", {"R", "G", "B", "A"});
    image.add("variance", {"R", "G", "B"});
    const auto n = static_cast<double>(samples_);
    for (std::size_t i = 0; i < image.pixel_count(); ++i) {
        for (std::size_t c = 0; c < 3; ++c) {
            const double m = sums_[3 * i + c] / n;
            const double spread = std::max(squares_[3 * i + c] / n - m * m, 0.0);
            image.layers[0].pixels[4 * i + c] = static_cast<float>(m);
            image.layers[1].pixels[3 * i + c] =
                static_cast<float>(samples_ > 1 ? spread / (n - 1) : squares_[3 * i + c]);
        }
        image.layers[0].pixels[4 * i + 3] = 1;
    }
    return image;
}

} // namespace ajar
