// Separable convolution of one plane with replicated borders: rows, then columns.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace ajar {

// Adds `in`, convolved along x by `row_taps` and along y by `column_taps` (odd lengths), to `sum`.
void add_convolved(const std::vector<float>& in, std::uint32_t width, std::uint32_t height,
                   std::span<const float> row_taps, std::span<const float> column_taps,
                   std::vector<float>& sum);

} // namespace ajar
