#include "image/relative_error.hpp"

#include "base/error.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace ajar {

RelativeError relative_error(const Image& test, const Image& reference) {
    const Layer &a = beauty(test, "image"), &b = beauty(reference, "reference");
    if (test.width != reference.width || test.height != reference.height || test.pixel_count() == 0)
        throw Error(fmt::format("image: is {} x {} pixels, but the reference is {} x {}", test.width,
                                test.height, reference.width, reference.height));
    const auto pixels = static_cast<double>(reference.pixel_count());
    double sum = 0, squares = 0, mean_a = 0, mean_b = 0;
    for (std::size_t i = 0; i < reference.pixel_count(); ++i) {
        double pixel = 0;
        for (std::size_t c = 0; c < 3; ++c) {
            const double x = a.pixels[i * a.channels + c], r = b.pixels[i * b.channels + c];
            pixel += relative_square(x, r) / 3;
            mean_a += x, mean_b += r;
        }
        sum += pixel, squares += pixel * pixel;
    }
    RelativeError result;
    result.mse = sum / pixels;
    const double spread = std::max(squares / pixels - result.mse * result.mse, 0.0);
    result.standard_error = pixels > 1 ? std::sqrt(spread / (pixels - 1)) : result.mse;
    result.mean_shift = mean_b > 0 ? mean_a / mean_b - 1 : 0;
    return result;
}

double relative_variance(const Image& image) {
    const Layer& b = beauty(image, "reference");
    const Layer* variance = image.find("variance");
    if (!variance || variance->channels < 3) throw Error("reference: has no layer 'variance' with R, G, B");
    double sum = 0;
    for (std::size_t i = 0; i < image.pixel_count(); ++i)
        for (std::size_t c = 0; c < 3; ++c) {
            const double r = b.pixels[i * b.channels + c];
            sum += std::max(double{variance->pixels[i * variance->channels + c]}, 0.0) / (r * r + 0.01);
        }
    return sum / (3 * static_cast<double>(std::max<std::size_t>(image.pixel_count(), 1)));
}

} // namespace ajar
