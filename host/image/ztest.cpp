#include "image/ztest.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace ajar {
namespace {

// What one block has gathered of one channel.
struct Sums {
    double difference = 0, variance = 0, slack = 0;

    double z() const {
        const double beyond = std::max(0.0, std::abs(difference) - slack);
        if (beyond == 0) return 0;
        const double size =
            variance > 0 ? beyond / std::sqrt(variance) : std::numeric_limits<double>::infinity();
        return std::copysign(size, difference);
    }
};

// Half a unit in the last place; below the smallest normal half float (2^-14) the units stop shrinking.
double rounding(const Layer& layer, float value) {
    const double smallest_normal = layer.rounding > 0x1p-24f ? 0x1p-14 : 0x1p-126;
    return layer.rounding * std::max(std::abs(double{value}), smallest_normal);
}

} // namespace

double two_sided_p(double z) { return std::erfc(std::abs(z) / std::sqrt(2.0)); }

double sidak(double p, std::uint64_t tests) {
    return -std::expm1(static_cast<double>(tests) * std::log1p(-p));
}

double sidak_level(double significance, std::uint64_t tests) {
    return -std::expm1(std::log1p(-significance) / static_cast<double>(tests));
}

ZTest z_test(const Image& a, const Image& b, BlockSize block, double significance) {
    const Layer &la = *a.find(""), &lb = *b.find(""), &va = *a.find("variance"), &vb = *b.find("variance");
    assert(a.width == b.width && a.height == b.height && block.width > 0 && block.height > 0);
    const std::uint64_t columns = (a.width + std::uint64_t{block.width} - 1) / block.width;
    const std::uint64_t lines = (a.height + std::uint64_t{block.height} - 1) / block.height;
    ZTest result;
    result.tests = 3 * columns * lines;
    const double level = sidak_level(significance, result.tests);
    std::vector<Sums> sums(3 * columns); // of one line of blocks
    for (std::uint32_t y = 0; y < a.height; ++y) {
        for (std::uint32_t x = 0; x < a.width; ++x)
            for (std::size_t c = 0; c < 3; ++c) {
                const std::size_t i = std::size_t{y} * a.width + x;
                const float pa = la.pixels[i * la.channels + c], pb = lb.pixels[i * lb.channels + c];
                const double noise = std::max(0.0f, va.pixels[i * va.channels + c]) +
                                     double{std::max(0.0f, vb.pixels[i * vb.channels + c])};
                const double rounded = rounding(la, pa) + rounding(lb, pb);
                Sums& sum = sums[3 * (x / block.width) + c];
                sum.difference += double{pa} - double{pb};
                sum.variance += noise;
                if (noise > rounded * rounded)
                    sum.variance += rounded * rounded / 3; // uniform in +-rounded
                else
                    sum.slack += rounded;
            }
        if ((y + 1) % block.height != 0 && y + 1 != a.height) continue;
        for (std::size_t s = 0; s < sums.size(); ++s) {
            const double z = sums[s].z(), p = two_sided_p(z);
            result.rejected += p < level;
            if (std::abs(z) <= std::abs(result.z)) continue;
            result.z = z, result.p = p;
            result.x = static_cast<std::uint32_t>(s / 3) * block.width;
            result.y = y / block.height * block.height;
            result.channel = static_cast<std::uint32_t>(s % 3);
        }
        std::fill(sums.begin(), sums.end(), Sums{});
    }
    result.corrected_p = sidak(result.p, result.tests);
    return result;
}

} // namespace ajar
