// Tests that decide by statistics: chi-square and z-tests with Sidak's correction, at one level for the whole
// house.
#pragma once

#include <cstddef>
#include <span>

namespace ajar::test {

// A right program fails a test that uses this level once in ten thousand seeds; seeds are fixed.
inline constexpr double SIGNIFICANCE = 1e-4;

// The level of each of `tests` independent tests, so that all together have `level` (Sidak 1967).
double sidak_level(double level, std::size_t tests);

// Upper tail of the chi-square distribution: probability of at least `statistic`.
double chi_square_tail(double statistic, double degrees);

// Probability of a standard normal at least that far from 0, on either side.
double normal_two_sided(double z);

// Pearson's test of counts against expectations whose sums agree (what is lost needs a bin of its own). Bins
// are pooled, in order of expectation, until each pool expects at least 5.
struct ChiSquare {
    double statistic = 0;
    std::size_t degrees = 0;
    double p = 1; // 0 where something happened that has expectation 0
};
ChiSquare chi_square(std::span<const double> observed, std::span<const double> expected);

// Mean and variance as samples come in (Welford 1962).
class Moments {
  public:
    void add(double x);
    std::size_t count() const { return count_; }
    double mean() const { return mean_; }
    double variance() const;       // of one sample, unbiased
    double standard_error() const; // of the mean

  private:
    std::size_t count_ = 0;
    double mean_ = 0;
    double squares_ = 0;
};

// Probability of a mean at least that far from `expected`. `tolerance`: by which `expected` itself, or
// rounding in the estimate, may be off.
double mean_p_value(const Moments& moments, double expected, double tolerance = 0);
// Of two means at least that far apart.
double mean_p_value(const Moments& a, const Moments& b);

} // namespace ajar::test
