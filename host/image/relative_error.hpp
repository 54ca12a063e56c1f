// relMSE, the mean of (a - b)^2 / (b^2 + 0.01) over R, G and B with b the reference: the error that
// renderers are compared by, with what it takes to judge the figure itself.
#pragma once

#include "image/image.hpp"

namespace ajar {

// The 0.01 keeps dark pixels from deciding (Rousselle, Knaus and Zwicker 2011).
inline double relative_square(double a, double b) { return (a - b) * (a - b) / (b * b + 0.01); }

struct RelativeError {
    double mse = 0;
    double standard_error = 0; // of `mse`, by its spread from pixel to pixel
    double mean_shift = 0;     // mean of a over mean of b, less 1; 0 for a black reference
};

// Both have the beauty layer. Throws Error: sizes differ, a layer is missing.
RelativeError relative_error(const Image& test, const Image& reference);

// The relMSE that an image's own noise amounts to: the mean of variance / (b^2 + 0.01), by its layer
// "variance". Throws Error where there is none.
double relative_variance(const Image& image);

} // namespace ajar
