#include "radiosity/reciprocity.hpp"

#include <algorithm>
#include <cmath>

namespace ajar {

Reciprocity measure_reciprocity(const RadiosityRig& rig, FormFactors& factors, std::uint32_t rows) {
    std::vector<std::uint32_t> row_of(rig.side_count());
    for (std::uint32_t row = 0; row < factors.row_count(); ++row) row_of[factors.row_sides()[row]] = row;
    const std::uint32_t samples = std::min(rows, factors.row_count());
    const double rays = factors.rays();
    Reciprocity result;
    double differences = 0;
    double variances = 0;
    double means = 0;
    for (std::uint32_t k = 0; k < samples; ++k) {
        const auto row = static_cast<std::uint32_t>(std::uint64_t{k} * factors.row_count() / samples);
        const std::uint32_t i = factors.row_sides()[row];
        // What the next row's first ray met: a neighbour sees much the same, and knows nothing of this row's
        // rays. Chosen by one of those, the others would be stratified away from it.
        const std::uint32_t j = factors.entries((row + 1) % factors.row_count())[0];
        if (j >= rig.side_count()) continue;
        const std::vector<std::uint32_t> to = factors.entries(row);
        const std::vector<std::uint32_t> back = factors.entries(row_of[j]);
        const double f_ij = static_cast<double>(std::count(to.begin(), to.end(), j)) / rays;
        const double f_ji = static_cast<double>(std::count(back.begin(), back.end(), i)) / rays;
        const double a_i = rig.mesh.patches[i / 2].area;
        const double a_j = rig.mesh.patches[j / 2].area;
        const double difference = std::abs(a_i * f_ij - a_j * f_ji);
        ++result.pairs;
        result.max = std::max(result.max, difference);
        differences += difference * difference;
        const double mean = 0.5 * (a_i * f_ij + a_j * f_ji);
        // Of a binomial share of the rays, were the product that mean.
        variances += mean * (std::max(a_i - mean, 0.0) + std::max(a_j - mean, 0.0)) / rays;
        means += mean * mean;
    }
    if (!(means > 0)) return result;
    result.rms = std::sqrt(differences / means);
    result.expected = std::sqrt(variances / means);
    result.max /= std::sqrt(means / static_cast<double>(result.pairs));
    return result;
}

} // namespace ajar
