// Runs a function of shaders/core over many items (shaders/core_functions.comp).
#pragma once

#include "shaders/core_functions.glsl.h"
#include "shaders/shared/specialization.glsl.h"
#include "support/gpu_test.hpp"

#include <bit>
#include <glm/glm.hpp>
#include <random>
#include <test_kernels.hpp>
#include <vector>

namespace ajar::test {

// Which sampler CORE_SAMPLER asks, and how long its sequence is if it is blue noise.
struct SamplerVariant {
    std::uint32_t sampler = shared::SAMPLER_SOBOL;
    std::uint32_t samples_log2 = 0;
};

class CoreFunctions : public GpuTest {
  protected:
    static std::vector<glm::uvec4> run(std::uint32_t function, const std::vector<glm::uvec4>& items,
                                       const glm::vec4& parameters = {}, SamplerVariant variant = {}) {
        const gpu::Kernel<shared::CoreFunctionsArgs> kernel(device(), gpu::test_kernels(), "core_functions",
                                                            {{shared::SPEC_WORKGROUP_SIZE, WORKGROUP_SIZE},
                                                             {shared::SPEC_OPTION, function},
                                                             {shared::SPEC_SAMPLER, variant.sampler}});
        gpu::Buffer in(device(), items.size() * sizeof(glm::uvec4), "items in");
        const gpu::Buffer out(device(), items.size() * sizeof(glm::uvec4), "items out");
        in.write(std::span<const glm::uvec4>(items));
        const gpu::Bindings bindings(device());
        gpu::Commands commands(device());
        commands.bind(bindings);
        const auto count = static_cast<std::uint32_t>(items.size());
        kernel.dispatch(commands, {{in.address()}, {out.address()}, parameters, count, variant.samples_log2},
                        groups_of(items.size()));
        commands.submit();
        return out.read<glm::uvec4>(0, items.size());
    }

    static std::vector<glm::vec4> run(std::uint32_t function, const std::vector<glm::vec4>& items,
                                      const glm::vec4& parameters = {}) {
        std::vector<glm::uvec4> words;
        words.reserve(items.size());
        for (const glm::vec4& item : items) words.push_back(std::bit_cast<glm::uvec4>(item));
        std::vector<glm::vec4> results;
        results.reserve(items.size());
        for (const glm::uvec4& word : run(function, words, parameters))
            results.push_back(std::bit_cast<glm::vec4>(word));
        return results;
    }

    // Points of the unit square, [0, 1)^2 in steps of 2^-24, then their corners and edges.
    static std::vector<glm::vec4> uniform_points(std::size_t count, std::uint32_t seed) {
        std::mt19937 random(seed);
        const auto uniform = [&] { return static_cast<float>(random() >> 8) * 0x1p-24f; };
        std::vector<glm::vec4> points(count);
        for (glm::vec4& p : points) {
            p.x = uniform();
            p.y = uniform();
        }
        return points;
    }
};

inline constexpr float LARGEST_UNIFORM = 1 - 0x1p-24f;

} // namespace ajar::test
