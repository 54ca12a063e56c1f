#include "image/convergence.hpp"

#include <algorithm>
#include <cmath>

namespace ajar {

namespace {

// Of an error that is known no better than to a thousandth no more is claimed: pixels share lights.
constexpr double LEAST_RELATIVE = 1e-3;

// Of a slope, beyond which -1/2 could hardly be told from -1/3 at the level below.
constexpr double LARGEST_ERROR = 0.04;

} // namespace

std::optional<SlopeFit> fit_slope(const std::vector<ErrorPoint>& points) {
    double count = 0, weights = 0, mean_x = 0, mean_y = 0;
    const auto usable = [](const ErrorPoint& p) {
        return p.samples > 0 && p.mse > 0 && std::isfinite(p.mse);
    };
    const auto weight = [](const ErrorPoint& p) {
        const double sigma = 0.5 * std::max(p.standard_error / p.mse, LEAST_RELATIVE); // of log sqrt(mse)
        return 1 / (sigma * sigma);
    };
    for (const ErrorPoint& p : points) {
        if (!usable(p)) continue;
        const double w = weight(p);
        count += 1, weights += w;
        mean_x += w * std::log(p.samples), mean_y += w * 0.5 * std::log(p.mse);
    }
    if (count < 3) return std::nullopt;
    mean_x /= weights, mean_y /= weights;
    double xx = 0, xy = 0;
    for (const ErrorPoint& p : points) {
        if (!usable(p)) continue;
        const double x = std::log(p.samples) - mean_x;
        xx += weight(p) * x * x, xy += weight(p) * x * (0.5 * std::log(p.mse) - mean_y);
    }
    if (!(xx > 1e-9 * weights)) return std::nullopt;
    SlopeFit fit{xy / xx, 0};
    double chi_square = 0;
    for (const ErrorPoint& p : points) {
        if (!usable(p)) continue;
        const double off = 0.5 * std::log(p.mse) - mean_y - fit.slope * (std::log(p.samples) - mean_x);
        chi_square += weight(p) * off * off;
    }
    fit.standard_error = std::sqrt(std::max(1.0, chi_square / (count - 2)) / xx);
    return fit;
}

SlopeVerdict judge(const SlopeFit& fit) {
    const double off = fit.slope + 0.5;
    const bool differs = std::abs(off) >= std::max(3.9 * fit.standard_error, 0.02);
    if (!differs && fit.standard_error > LARGEST_ERROR) return SlopeVerdict::undecided;
    if (!differs) return SlopeVerdict::as_independent;
    return off < 0 ? SlopeVerdict::steeper : SlopeVerdict::flatter;
}

} // namespace ajar
