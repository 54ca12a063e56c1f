#include "support/statistics.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>
#include <vector>

namespace ajar::test {

namespace {

// Regularised upper incomplete gamma function Q(a, x): series below a + 1, Lentz's continued fraction above
// (Abramowitz and Stegun 6.5.29 and 6.5.31).
double gamma_tail(double a, double x) {
    if (x <= 0) return 1;
    const double front = std::exp(a * std::log(x) - x - std::lgamma(a));
    if (x < a + 1) {
        double term = 1 / a;
        double sum = term;
        for (double n = a + 1; term > sum * 1e-16; ++n) {
            term *= x / n;
            sum += term;
        }
        return 1 - front * sum;
    }
    double b = x + 1 - a;
    double c = 1e300;
    double d = 1 / b;
    double fraction = d;
    for (int n = 1; n < 100000; ++n) {
        const double step = n * (a - n);
        b += 2;
        d = 1 / (b + step * d);
        c = b + step / c;
        fraction *= c * d;
        if (std::abs(c * d - 1) < 1e-15) break;
    }
    return front * fraction;
}

} // namespace

double sidak_level(double level, std::size_t tests) {
    return -std::expm1(std::log1p(-level) / static_cast<double>(tests));
}

double chi_square_tail(double statistic, double degrees) {
    return gamma_tail(0.5 * degrees, 0.5 * statistic);
}

double normal_two_sided(double z) { return std::erfc(std::abs(z) / std::sqrt(2.0)); }

ChiSquare chi_square(std::span<const double> observed, std::span<const double> expected) {
    assert(observed.size() == expected.size());
    std::vector<std::size_t> order(expected.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return expected[a] < expected[b]; });

    ChiSquare result;
    std::size_t pools = 0;
    double pool_observed = 0;
    double pool_expected = 0;
    double impossible = 0;
    for (std::size_t k = 0; k < order.size(); ++k) {
        const std::size_t bin = order[k];
        if (expected[bin] <= 0) {
            impossible += observed[bin];
            continue;
        }
        pool_observed += observed[bin];
        pool_expected += expected[bin];
        if (pool_expected < 5) continue;
        result.statistic += (pool_observed - pool_expected) * (pool_observed - pool_expected) / pool_expected;
        pool_observed = pool_expected = 0;
        ++pools;
    }
    // Bins come in ascending order, so what is left never reached 5: too little to test.
    result.degrees = pools > 1 ? pools - 1 : 0;
    if (result.degrees > 0) result.p = chi_square_tail(result.statistic, static_cast<double>(result.degrees));
    if (impossible > 0) result.p = 0;
    return result;
}

void Moments::add(double x) {
    ++count_;
    const double delta = x - mean_;
    mean_ += delta / static_cast<double>(count_);
    squares_ += delta * (x - mean_);
}

double Moments::variance() const { return count_ > 1 ? squares_ / static_cast<double>(count_ - 1) : 0; }

double Moments::standard_error() const {
    return count_ > 0 ? std::sqrt(variance() / static_cast<double>(count_)) : 0;
}

double mean_p_value(const Moments& moments, double expected, double tolerance) {
    const double distance = std::max(std::abs(moments.mean() - expected) - tolerance, 0.0);
    if (distance == 0) return 1;
    return moments.standard_error() > 0 ? normal_two_sided(distance / moments.standard_error()) : 0;
}

double mean_p_value(const Moments& a, const Moments& b) {
    const double distance = std::abs(a.mean() - b.mean());
    const double error = std::hypot(a.standard_error(), b.standard_error());
    if (distance == 0) return 1;
    return error > 0 ? normal_two_sided(distance / error) : 0;
}

} // namespace ajar::test
