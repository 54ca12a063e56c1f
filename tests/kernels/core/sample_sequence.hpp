// Fixture of the samplers' tests: points of a sampler, and what it means for them to be spread evenly.
#pragma once

#include "core_functions.hpp"
#include "shaders/shared/dimensions.glsl.h"
#include "support/statistics.hpp"

#include <cmath>
#include <set>
#include <span>
#include <utility>

namespace ajar::test {

class SampleSequence : public CoreFunctions {
  protected:
    // Keys: seed, ordinal of the pixel, sample, dimension. Points: the pair of dimensions (x, y), the single
    // (z).
    static std::vector<glm::vec4> points(const std::vector<glm::uvec4>& keys, SamplerVariant variant = {}) {
        std::vector<glm::vec4> all;
        all.reserve(keys.size());
        for (const glm::uvec4& word : run(shared::CORE_SAMPLER, keys, {}, variant))
            all.push_back(std::bit_cast<glm::vec4>(word));
        return all;
    }
};

// Of 2^m points, each elementary interval 2^-a x 2^-(m - a) of the square has one.
inline void expect_net(std::span<const glm::vec4> block, int m) {
    for (int a = 0; a <= m; ++a) {
        std::set<std::pair<int, int>> cells;
        for (const glm::vec4& p : block)
            cells.emplace(static_cast<int>(std::ldexp(p.x, a)), static_cast<int>(std::ldexp(p.y, m - a)));
        ASSERT_EQ(cells.size(), std::size_t{1} << m) << "2^-" << a << " x 2^-" << m - a;
    }
}

// p-value of (a, b) being independent and uniform: a 16 x 16 table.
inline double independence(std::span<const float> a, std::span<const float> b) {
    std::vector<double> observed(256);
    for (std::size_t k = 0; k < a.size(); ++k)
        ++observed[static_cast<std::size_t>(a[k] * 16) * 16 + static_cast<std::size_t>(b[k] * 16)];
    const std::vector<double> expected(256, static_cast<double>(a.size()) / 256);
    return chi_square(observed, expected).p;
}

} // namespace ajar::test
