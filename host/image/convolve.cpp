#include "image/convolve.hpp"

#include <algorithm>
#include <cassert>
#include <cstddef>

namespace ajar {

// The inner loops run along x over whole rows, so that the compiler vectorizes them; a tap is a constant
// there.
void add_convolved(const std::vector<float>& in, std::uint32_t width, std::uint32_t height,
                   std::span<const float> row_taps, std::span<const float> column_taps,
                   std::vector<float>& sum) {
    const std::size_t w = width, h = height;
    assert(in.size() == w * h && sum.size() == in.size() && row_taps.size() % 2 == 1 &&
           column_taps.size() % 2 == 1);
    const std::size_t row_radius = row_taps.size() / 2, column_radius = column_taps.size() / 2;
    std::vector<float> rows(in.size(), 0.0f), padded(w + 2 * row_radius);
    for (std::size_t y = 0; y < h; ++y) {
        const float* from = in.data() + y * w;
        std::fill_n(padded.begin(), row_radius, from[0]);
        std::copy_n(from, w, padded.begin() + static_cast<std::ptrdiff_t>(row_radius));
        std::fill_n(padded.end() - static_cast<std::ptrdiff_t>(row_radius), row_radius, from[w - 1]);
        float* to = rows.data() + y * w;
        for (std::size_t k = 0; k < row_taps.size(); ++k) {
            const float tap = row_taps[k];
            const float* shifted = padded.data() + k;
            for (std::size_t x = 0; x < w; ++x) to[x] += tap * shifted[x];
        }
    }
    for (std::size_t y = 0; y < h; ++y) {
        float* to = sum.data() + y * w;
        for (std::size_t k = 0; k < column_taps.size(); ++k) {
            const std::size_t below = std::min(y + k, h - 1 + column_radius);
            const float* from = rows.data() + (below < column_radius ? 0 : below - column_radius) * w;
            const float tap = column_taps[k];
            for (std::size_t x = 0; x < w; ++x) to[x] += tap * from[x];
        }
    }
}

} // namespace ajar
