// Alias tables: slots of equal capacity in integer units; small masses are topped up from large ones until
// none is left.
#include "render/alias_table.hpp"

#include "base/error.hpp"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <string>

namespace ajar {

std::vector<std::uint32_t> apportion(std::span<const double> weights, std::uint32_t total) {
    std::vector<std::uint32_t> masses(weights.size(), 0);
    double largest = 0;
    std::uint64_t positive = 0;
    for (const double w : weights) {
        assert(std::isfinite(w) && w >= 0);
        largest = std::max(largest, w);
        positive += w > 0 ? 1 : 0;
    }
    if (positive == 0) return masses;
    if (positive > total)
        throw Error("lights: " + std::to_string(positive) + " entries in one distribution: at most " +
                    std::to_string(total) + " are possible (merge some)");
    // Relative to the largest, so that the sum can't overflow.
    double sum = 0;
    for (const double w : weights) sum += w / largest;
    // Rounding the running sum keeps the total exact without sorting remainders.
    const double shared_units = static_cast<double>(total - positive);
    double prefix = 0;
    std::uint32_t given = 0;
    std::size_t last = 0;
    for (std::size_t i = 0; i < weights.size(); ++i) {
        if (!(weights[i] > 0)) continue;
        prefix += weights[i] / largest;
        const auto upto = static_cast<std::uint32_t>(std::floor(std::min(prefix / sum, 1.0) * shared_units));
        masses[i] = 1 + (upto - given);
        given = upto;
        last = i;
    }
    masses[last] += static_cast<std::uint32_t>(total - positive) - given;
    return masses;
}

AliasTable build_alias_table(std::span<const double> weights) {
    if (weights.size() > PROBABILITY_UNITS)
        throw Error("lights: " + std::to_string(weights.size()) + " of them: at most " +
                    std::to_string(PROBABILITY_UNITS) + " are possible (merge some)");
    const auto slots = static_cast<std::uint32_t>(std::bit_ceil(std::max<std::size_t>(weights.size(), 1)));
    const std::uint32_t capacity = PROBABILITY_UNITS / slots;
    std::vector<std::uint32_t> left = apportion(weights, PROBABILITY_UNITS);

    AliasTable table;
    for (const std::uint32_t mass : left)
        table.pmf.push_back(static_cast<float>(mass) / static_cast<float>(PROBABILITY_UNITS));
    left.resize(slots, 0);
    table.entries.resize(slots);
    std::vector<std::uint32_t> small;
    std::vector<std::uint32_t> large;
    for (std::uint32_t i = 0; i < slots; ++i) {
        table.entries[i] = {1.0f, i, i, 0};
        if (left[i] < capacity)
            small.push_back(i);
        else if (left[i] > capacity)
            large.push_back(i);
    }
    // The masses sum to slots * capacity, so small ones are left over only where all weights are 0.
    while (!small.empty() && !large.empty()) {
        const std::uint32_t taker = small.back();
        const std::uint32_t giver = large.back();
        small.pop_back();
        table.entries[taker].keep = static_cast<float>(left[taker]) / static_cast<float>(capacity);
        table.entries[taker].other = giver;
        left[giver] -= capacity - left[taker];
        if (left[giver] > capacity) continue;
        large.pop_back();
        if (left[giver] < capacity) small.push_back(giver);
    }
    return table;
}

} // namespace ajar
