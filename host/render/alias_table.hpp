// Alias tables for the power light sampler (Walker 1977; Vose 1991), in integers of 2^-24: random numbers
// come in such steps (shaders/core/rng.glsl), so the pmf stated here is exactly the kernel's, however many
// entries there are.
#pragma once

#include "shaders/shared/light.glsl.h"

#include <cstdint>
#include <span>
#include <vector>

namespace ajar {

inline constexpr std::uint32_t PROBABILITY_UNITS = 1u << 24;

// Integers that sum to `total`, each within 1 of the weights' shares of what is left once every positive
// weight has got 1; weights of 0 get 0. All 0 when no weight is positive. Weights must be finite and not
// negative; at most `total` of them may be positive (else Error).
std::vector<std::uint32_t> apportion(std::span<const double> weights, std::uint32_t total);

struct AliasTable {
    std::vector<shared::AliasEntry>
        entries;            // 2^k of them, the first such number that is not below weights.size()
    std::vector<float> pmf; // per weight; multiples of 2^-24, sum exactly 1 (or 0: all weights 0)
};

// Throws Error for more than PROBABILITY_UNITS weights.
AliasTable build_alias_table(std::span<const double> weights);

} // namespace ajar
