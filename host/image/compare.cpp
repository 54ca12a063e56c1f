#include "image/compare.hpp"

#include "base/error.hpp"
#include "image/relative_error.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace ajar {
namespace {

void require_finite(const Image& image, const Layer& layer, const std::string& name) {
    for (std::size_t i = 0; i < image.pixel_count(); ++i)
        for (std::size_t c = 0; c < 3; ++c)
            if (const float value = layer.pixels[i * layer.channels + c]; !std::isfinite(value))
                throw Error(fmt::format("{}: pixel ({}, {}): {}{} is {}, which cannot be compared", name,
                                        i % image.width, i / image.width,
                                        layer.name.empty() ? "" : layer.name + ".", "RGB"[c], value));
}

const Layer* variance(const Image& image, const std::string& name) {
    const Layer* layer = image.find("variance");
    if (!layer) return nullptr;
    if (layer->channels < 3 || layer->pixels.size() != image.pixel_count() * layer->channels)
        throw Error(fmt::format("{}: its layer 'variance' has no R, G, B", name));
    require_finite(image, *layer, name);
    return layer;
}

ColorPlanes planes(const Image& image, const Layer& layer) {
    ColorPlanes result{image.width, image.height, {}};
    for (std::size_t c = 0; c < 3; ++c) {
        result.channel[c].reserve(image.pixel_count());
        for (std::size_t i = 0; i < image.pixel_count(); ++i)
            result.channel[c].push_back(layer.pixels[i * layer.channels + c]);
    }
    return result;
}

void measure_errors(const Layer& test, const Layer& reference, Range range, Comparison& result) {
    double squares = 0, relative = 0, peak = range == Range::display ? 1 : 0;
    const std::size_t count = reference.pixels.size() / reference.channels;
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t c = 0; c < 3; ++c) {
            const double a = test.pixels[i * test.channels + c],
                         b = reference.pixels[i * reference.channels + c];
            const double square = (a - b) * (a - b);
            squares += square;
            relative += relative_square(a, b);
            if (range == Range::scene) peak = std::max(peak, b);
            if (std::abs(a - b) <= result.max_error) continue;
            result.max_error = std::abs(a - b);
            result.max_x = static_cast<std::uint32_t>(i % result.width);
            result.max_y = static_cast<std::uint32_t>(i / result.width);
            result.max_channel = static_cast<std::uint32_t>(c);
        }
    const double values = 3 * static_cast<double>(count);
    result.rmse = std::sqrt(squares / values);
    result.relmse = relative / values;
    result.psnr = squares > 0 ? 20 * std::log10(peak / result.rmse) : std::numeric_limits<double>::infinity();
}

// Adds a reason where a limit is set and broken.
void check(const char* name, double value, const std::optional<double>& limit, Verdict& verdict) {
    if (!limit || value <= *limit) return;
    verdict.same = false;
    verdict.reasons.push_back(fmt::format("{} {:.6g} is above {:.6g}", name, value, *limit));
}

void check(const char* name, const std::optional<ZTest>& test, double level, Verdict& verdict) {
    if (test->corrected_p >= level) return;
    verdict.same = false;
    verdict.reasons.push_back(fmt::format("noise does not explain the {}: {} of {} tests rejected, the worst "
                                          "at ({}, {}) {}: z = {:.1f}, p = {:.2g} "
                                          "corrected",
                                          name, test->rejected, test->tests, test->x, test->y,
                                          "RGB"[test->channel], test -> z, test -> corrected_p));
}

} // namespace

Comparison compare(const Image& test, const Image& reference, const CompareOptions& options) {
    const Layer& a = beauty(test, options.test_name);
    const Layer& b = beauty(reference, options.reference_name);
    if (test.width != reference.width || test.height != reference.height)
        throw Error(fmt::format("{}: is {} x {} pixels, but {} is {} x {}", options.test_name, test.width,
                                test.height, options.reference_name, reference.width, reference.height));
    if (test.pixel_count() == 0) throw Error(fmt::format("{}: has no pixels", options.test_name));
    require_finite(test, a, options.test_name);
    require_finite(reference, b, options.reference_name);

    Comparison result;
    result.width = test.width;
    result.height = test.height;
    const bool scene = test.range == Range::scene && reference.range == Range::scene;
    measure_errors(a, b, scene ? Range::scene : Range::display, result);

    result.flip_kind = options.flip != FlipKind::automatic ? options.flip
                       : scene                             ? FlipKind::hdr
                                                           : FlipKind::ldr;
    const auto flip = result.flip_kind == FlipKind::hdr ? flip_hdr : flip_ldr;
    result.flip_error = flip(planes(reference, b), planes(test, a), options.pixels_per_degree);
    for (const float error : result.flip_error) result.flip += error;
    result.flip /= static_cast<double>(test.pixel_count());

    result.significance = options.significance;
    if (variance(test, options.test_name) && variance(reference, options.reference_name)) {
        const auto at = [&](BlockSize block) { return z_test(test, reference, block, options.significance); };
        result.image_z = at({test.width, test.height});
        result.tile_z = at({options.tile, options.tile});
        result.pixel_z = at({1, 1});
    }
    return result;
}

Verdict judge(const Comparison& comparison, const Limits& limits) {
    Verdict verdict;
    check("FLIP", comparison.flip, limits.max_flip, verdict);
    check("RMSE", comparison.rmse, limits.max_rmse, verdict);
    check("relMSE", comparison.relmse, limits.max_relmse, verdict);
    check("maximal error", comparison.max_error, limits.max_error, verdict);
    const bool z_tests = comparison.image_z && !limits.z_scales.empty();
    if (z_tests) {
        // The scales share the chance of a false alarm.
        const double level = sidak_level(comparison.significance, limits.z_scales.size());
        for (const ZScale scale : limits.z_scales) {
            if (scale == ZScale::image) check("whole image", comparison.image_z, level, verdict);
            if (scale == ZScale::tiles) check("tiles", comparison.tile_z, level, verdict);
            if (scale == ZScale::pixels) check("pixels", comparison.pixel_z, level, verdict);
        }
    }
    const bool limited = limits.max_flip || limits.max_rmse || limits.max_relmse || limits.max_error;
    if (!z_tests && !limited) check("maximal error", comparison.max_error, 0.0, verdict);
    return verdict;
}

} // namespace ajar
