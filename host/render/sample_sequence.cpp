#include "render/sample_sequence.hpp"

#include "base/error.hpp"
#include "render/choices.hpp"
#include "shaders/shared/specialization.glsl.h"

#include <bit>
#include <fmt/format.h>

namespace ajar {

namespace {

constexpr std::uint32_t MOST_SAMPLES = 1u << 31; // the kernels shift by the logarithm

} // namespace

std::uint32_t sequence_samples(const RenderSettings& settings) {
    if (find_sampler(settings.sampler) != shared::SAMPLER_BLUE_NOISE) return 0;
    const std::uint64_t end = std::uint64_t{settings.first_sample} + settings.samples;
    if (end > MOST_SAMPLES || settings.sequence_samples > MOST_SAMPLES)
        throw Error(fmt::format("sampler blue-noise: at most {} samples (take sobol)", MOST_SAMPLES));
    if (settings.sequence_samples == 0) return std::bit_ceil(static_cast<std::uint32_t>(end));
    if (end > settings.sequence_samples)
        throw Error(
            fmt::format("sequence samples {}: samples up to {} are asked for (give the samples of all "
                        "runs together)",
                        settings.sequence_samples, end));
    return std::bit_ceil(settings.sequence_samples);
}

} // namespace ajar
