// How fast an error falls: the slope of log RMSE over log samples. Independent samples have -1/2;
// stratified ones less; rare bright paths, or an error that does not fall, such as a bias, more.
#pragma once

#include <optional>
#include <vector>

namespace ajar {

struct ErrorPoint {
    double samples = 0;
    double mse = 0;
    double standard_error = 0; // of mse
};

struct SlopeFit {
    double slope = 0;
    double standard_error = 0;
};

// By weighted least squares. The points must be of disjoint samples, for their errors to be independent;
// where they scatter more than their standard errors say, the fit's own grows with it (Birge 1932). Nothing
// from fewer than three points, or from points of one number of samples.
std::optional<SlopeFit> fit_slope(const std::vector<ErrorPoint>& points);

// undecided: the errors scatter too much to tell, as rare bright paths make them.
enum class SlopeVerdict : unsigned char { as_independent, steeper, flatter, undecided };
// Against -1/2, at about one false alarm in ten thousand; differences below 0.02 are not worth a word.
SlopeVerdict judge(const SlopeFit& fit);

} // namespace ajar
