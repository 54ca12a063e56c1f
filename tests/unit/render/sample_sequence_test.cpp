// How long a blue-noise sequence is, and which settings it refuses.
#include "render/sample_sequence.hpp"

#include "base/error.hpp"

#include <gtest/gtest.h>

namespace ajar::test {
namespace {

RenderSettings blue_noise(std::uint32_t first_sample, std::uint32_t samples, std::uint32_t sequence_samples) {
    RenderSettings settings;
    settings.sampler = "blue-noise";
    settings.first_sample = first_sample;
    settings.samples = samples;
    settings.sequence_samples = sequence_samples;
    return settings;
}

TEST(SampleSequence, IsTheNextPowerOfTwoOfAllSamplesUnlessItIsGiven) {
    EXPECT_EQ(sequence_samples(blue_noise(0, 1, 0)), 1u);
    EXPECT_EQ(sequence_samples(blue_noise(0, 3, 0)), 4u);
    EXPECT_EQ(sequence_samples(blue_noise(5, 3, 0)), 8u);
    EXPECT_EQ(sequence_samples(blue_noise(5, 3, 33)), 64u);
    EXPECT_EQ(sequence_samples(blue_noise(0, 1u << 31, 0)), 1u << 31);
}

TEST(SampleSequence, RefusesSamplesBeyondItsEnd) {
    EXPECT_EQ(sequence_samples(blue_noise(30, 3, 33)), 64u);
    EXPECT_THROW(sequence_samples(blue_noise(30, 3, 32)), Error);
    EXPECT_THROW(sequence_samples(blue_noise(0, 64, 1)), Error);
}

TEST(SampleSequence, RefusesMoreSamplesThanAnIndexHasBitsFor) {
    EXPECT_THROW(sequence_samples(blue_noise(1, 1u << 31, 0)), Error);
    EXPECT_THROW(sequence_samples(blue_noise(UINT32_MAX, UINT32_MAX, UINT32_MAX)), Error);
    EXPECT_THROW(sequence_samples(blue_noise(0, 1, UINT32_MAX)), Error);
}

TEST(SampleSequence, HasNoEndForOtherSamplers) {
    RenderSettings settings = blue_noise(1000, 64, 1);
    for (const char* sampler : {"sobol", "independent"}) {
        settings.sampler = sampler;
        EXPECT_EQ(sequence_samples(settings), 0u);
    }
    settings.sampler = "white-noise";
    EXPECT_THROW(sequence_samples(settings), Error) << "there is none of that name";
}

} // namespace
} // namespace ajar::test
