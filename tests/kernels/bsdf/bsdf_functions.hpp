// Runs a function of shaders/bsdf over many items (shaders/bsdf_functions.comp).
#pragma once

#include "configurations.hpp"
#include "shaders/bsdf_functions.glsl.h"
#include "shaders/shared/material.glsl.h"
#include "shaders/shared/specialization.glsl.h"
#include "support/gpu_test.hpp"

#include <map>
#include <random>
#include <test_kernels.hpp>
#include <vector>

namespace ajar::test {

inline constexpr std::uint32_t ALL_FEATURES = shared::FEATURE_SPECULAR | shared::FEATURE_DELTA;
inline constexpr float LARGEST_UNIFORM = 1 - 0x1p-24f;

struct Sampled {
    glm::vec3 wi;
    float pdf;
    glm::vec3 weight;
    float delta;
    bool absorbed() const { return pdf == 0 && delta == 0; }
};

class BsdfFunctions : public GpuTest {
  public:
    static void TearDownTestSuite() {
        kernels_.clear();
        GpuTest::TearDownTestSuite();
    }

  protected:
    // Writes count * words_out words.
    static std::vector<glm::vec4> run(std::uint32_t function, const Configuration& c, float alpha,
                                      const glm::vec3& wo, const std::vector<glm::vec4>& in,
                                      std::size_t count, std::size_t words_out = 1,
                                      std::uint32_t features = ALL_FEATURES) {
        const auto& kernel =
            kernels_
                .try_emplace({function, features}, device(), gpu::test_kernels(), "bsdf_functions",
                             gpu::Specialization{{shared::SPEC_WORKGROUP_SIZE, WORKGROUP_SIZE},
                                                 {shared::SPEC_OPTION, function},
                                                 {shared::SPEC_FEATURES, features}})
                .first->second;
        gpu::Buffer items_in(device(), in.size() * sizeof(glm::vec4), "items in");
        const gpu::Buffer items_out(device(), count * words_out * sizeof(glm::vec4), "items out");
        items_in.write(std::span<const glm::vec4>(in));
        const gpu::Bindings bindings(device());
        gpu::Commands commands(device());
        commands.bind(bindings);
        kernel.dispatch(commands,
                        {{items_in.address()},
                         {items_out.address()},
                         c.base_color,
                         c.metallic,
                         c.f0,
                         c.f90,
                         wo,
                         alpha,
                         static_cast<std::uint32_t>(count),
                         0},
                        groups_of(count));
        commands.submit();
        return items_out.read<glm::vec4>(0, count * words_out);
    }

    static std::vector<Sampled> sample(const Configuration& c, float alpha, const glm::vec3& wo,
                                       const std::vector<glm::vec4>& u,
                                       std::uint32_t features = ALL_FEATURES) {
        const auto words = run(shared::BSDF_SAMPLE, c, alpha, wo, u, u.size(), 2, features);
        std::vector<Sampled> samples(u.size());
        for (std::size_t k = 0; k < u.size(); ++k)
            samples[k] = {words[2 * k], words[2 * k].w, words[2 * k + 1], words[2 * k + 1].w};
        return samples;
    }

    // (f, pdf) of pairs: wo of the k-th at 2k, its wi at 2k + 1.
    static std::vector<glm::vec4> eval(const Configuration& c, float alpha,
                                       const std::vector<glm::vec4>& pairs,
                                       std::uint32_t features = ALL_FEATURES) {
        return run(shared::BSDF_EVAL, c, alpha, {}, pairs, pairs.size() / 2, 1, features);
    }

    static std::vector<glm::vec4> uniforms(std::size_t count, std::uint32_t seed) {
        std::mt19937 random(seed);
        const auto uniform = [&] { return static_cast<float>(random() >> 8) * 0x1p-24f; };
        std::vector<glm::vec4> u(count);
        for (glm::vec4& item : u) {
            item.x = uniform();
            item.y = uniform();
            item.z = uniform();
        }
        return u;
    }

    // In a plane askew to the axes, so that x and y are not interchangeable.
    static glm::vec3 outgoing(float degrees) {
        const float theta = glm::radians(degrees);
        return {std::sin(theta) * 0.8f, std::sin(theta) * 0.6f, std::cos(theta)};
    }

    // Pairs of directions of the upper hemisphere, all angles equally often.
    static std::vector<glm::vec4> pairs(std::size_t count, std::uint32_t seed) {
        std::vector<glm::vec4> all;
        for (const glm::vec4& u : uniforms(2 * count, seed)) {
            const float theta = u.x * 1.5707f;
            const float phi = u.y * 6.2831853f;
            all.emplace_back(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                             std::cos(theta), 0);
        }
        return all;
    }

  private:
    // Compiled once: a driver takes longer over that than over most runs.
    inline static std::map<std::pair<std::uint32_t, std::uint32_t>, gpu::Kernel<shared::BsdfFunctionsArgs>>
        kernels_;
};

} // namespace ajar::test
