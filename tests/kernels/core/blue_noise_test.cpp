// The blue-noise sampler: nets across pixels, and where in the spectrum of a picture its error lies.
#include "sample_sequence.hpp"

#include <complex>
#include <functional>
#include <numbers>

namespace ajar::test {
namespace {

constexpr std::uint32_t SIDE =
    64; // pixels: ordinals of a square whose side is a power of two are Morton codes

using Integrand = double (*)(double x, double y);

double edge(double x, double) { return x < 0.37 ? 1 : 0; }
double slanted_edge(double x, double y) { return x + y < 0.8 ? 1 : 0; }
double bell(double x, double y) { return std::exp(-4 * ((x - 0.4) * (x - 0.4) + (y - 0.6) * (y - 0.6))); }
double bell_mean() {
    const double side = std::sqrt(std::numbers::pi) / 4 * (std::erf(1.2) + std::erf(0.8));
    return side * side;
}

struct Case {
    Integrand f;
    double mean;
};
std::vector<Case> cases() { return {{edge, 0.37}, {slanted_edge, 0.32}, {bell, bell_mean()}}; }

class BlueNoise : public SampleSequence {
  protected:
    // The error of a picture in which every pixel has the same integrand, by ordinal.
    static std::vector<double> errors(const Case& integrand, std::uint32_t seed, SamplerVariant variant) {
        const std::uint32_t samples = 1u << variant.samples_log2;
        std::vector<glm::uvec4> keys;
        for (std::uint32_t ordinal = 0; ordinal < SIDE * SIDE; ++ordinal)
            for (std::uint32_t i = 0; i < samples; ++i) keys.emplace_back(seed, ordinal, i, 4);
        const auto all = points(keys, variant);
        std::vector<double> errors(SIDE * SIDE, -integrand.mean);
        for (std::size_t k = 0; k < all.size(); ++k)
            errors[k / samples] += integrand.f(double{all[k].x}, double{all[k].y}) / samples;
        return errors;
    }
};

std::uint32_t every_second_bit(std::uint32_t code) {
    std::uint32_t x = 0;
    for (std::uint32_t bit = 0; bit < 16; ++bit) x |= (code >> 2 * bit & 1u) << bit;
    return x;
}

// Energy of the picture at a frequency (cycles per picture); of white noise it is the pixels' variance.
double energy(const std::vector<double>& by_ordinal, int fx, int fy) {
    std::complex<double> sum = 0;
    for (std::uint32_t ordinal = 0; ordinal < SIDE * SIDE; ++ordinal) {
        const double cycles = (fx * static_cast<int>(every_second_bit(ordinal)) +
                               fy * static_cast<int>(every_second_bit(ordinal >> 1))) /
                              double{SIDE};
        sum += by_ordinal[ordinal] * std::polar(1.0, 2 * std::numbers::pi * cycles);
    }
    return std::norm(sum) / (SIDE * SIDE);
}

// Mean over the frequencies below `radius`, those and their negatives being one.
double low_energy(const std::vector<double>& by_ordinal, int radius) {
    Moments moments;
    for (int fx = -radius; fx <= radius; ++fx)
        for (int fy = 0; fy <= radius; ++fy)
            if (fx * fx + fy * fy <= radius * radius && (fy > 0 || fx >= 0))
                moments.add(energy(by_ordinal, fx, fy));
    return moments.mean();
}

double mean_square(const std::vector<double>& values) {
    double sum = 0;
    for (const double v : values) sum += v * v;
    return sum / static_cast<double>(values.size());
}

// Of the energy of white noise, the share that low frequencies have: over seeds.
Moments low_share(const std::function<std::vector<double>(std::uint32_t seed)>& picture) {
    Moments shares;
    for (std::uint32_t seed = 0; seed < 16; ++seed) {
        const std::vector<double> errors = picture(seed);
        shares.add(low_energy(errors, 6) / mean_square(errors));
    }
    return shares;
}

TEST_F(BlueNoise, EveryAlignedBlockOfPixelsAndOfSamplesIsANet) {
    for (const std::uint32_t samples_log2 : {0u, 1u, 2u, 5u}) {
        for (const std::uint32_t dimension : {0u, 6u}) {
            std::vector<glm::uvec4> keys;
            for (std::uint32_t ordinal = 0; ordinal < 1024; ++ordinal)
                for (std::uint32_t i = 0; i < 1u << samples_log2; ++i)
                    keys.emplace_back(11, 4096 + ordinal, i, dimension);
            const auto all = points(keys, {shared::SAMPLER_BLUE_NOISE, samples_log2});
            // Within a pixel blocks of any size; of pixels, whole squares.
            for (int m = 0; m <= static_cast<int>(samples_log2) + 10; ++m) {
                if (m > static_cast<int>(samples_log2) && (m - static_cast<int>(samples_log2)) % 2 == 1)
                    continue;
                const std::size_t size = std::size_t{1} << m;
                for (std::size_t block = 0; block < all.size() / size && block < 5; ++block)
                    expect_net(std::span(all).subspan(block * size, size), m);
            }
        }
    }
}

TEST_F(BlueNoise, ErrorsOfAPictureHaveLittleEnergyAtLowFrequencies) {
    for (const Case& integrand : cases()) {
        for (const std::uint32_t samples_log2 : {0u, 2u}) {
            const auto share = [&](std::uint32_t sampler) {
                return low_share([&](std::uint32_t seed) {
                    return errors(integrand, seed, {sampler, samples_log2});
                });
            };
            // Pixels that know nothing of each other have white errors, which also proves the measure.
            EXPECT_GT(mean_p_value(share(shared::SAMPLER_SOBOL), 1), SIGNIFICANCE);
            EXPECT_GT(mean_p_value(share(shared::SAMPLER_INDEPENDENT), 1), SIGNIFICANCE);
            const Moments blue = share(shared::SAMPLER_BLUE_NOISE);
            EXPECT_LT(blue.mean() + 4 * blue.standard_error(), 0.5) << samples_log2;
        }
    }
}

TEST_F(BlueNoise, ErrorsAreAlikeAlongRowsAndColumns) {
    // A plain Z-order has two to eight times the energy in one of the two.
    for (const std::uint32_t samples_log2 : {0u, 2u}) {
        Moments ratios; // logarithms, which have mean 0
        for (std::uint32_t seed = 0; seed < 16; ++seed) {
            const auto picture =
                errors({bell, bell_mean()}, seed, {shared::SAMPLER_BLUE_NOISE, samples_log2});
            double along_x = 0;
            double along_y = 0;
            for (int high = 24; high <= 32; ++high) {
                for (int low = -4; low <= 4; ++low) {
                    along_x += energy(picture, high, low);
                    along_y += energy(picture, low, high);
                }
            }
            ratios.add(std::log(along_x / along_y));
        }
        EXPECT_GT(mean_p_value(ratios, 0), SIGNIFICANCE) << ratios.mean();
        EXPECT_LT(ratios.standard_error(), 0.1) << "too few seeds to tell";
    }
}

TEST_F(BlueNoise, EstimatesOfAPixelAreUnbiasedOverSeeds) {
    constexpr std::uint32_t SEEDS = 4096;
    const std::uint32_t ordinals[] = {0, 1, 2, 3, 21, 4095, 1'000'000};
    for (const std::uint32_t ordinal : ordinals) {
        std::vector<glm::uvec4> keys;
        for (std::uint32_t seed = 0; seed < SEEDS; ++seed)
            for (std::uint32_t i = 0; i < 4; ++i) keys.emplace_back(seed, ordinal, i, 6);
        const auto all = points(keys, {shared::SAMPLER_BLUE_NOISE, 2});
        for (const Case& integrand : cases()) {
            Moments estimates;
            for (std::size_t seed = 0; seed < SEEDS; ++seed) {
                double sum = 0;
                for (std::size_t k = 4 * seed; k < 4 * seed + 4; ++k)
                    sum += integrand.f(double{all[k].x}, double{all[k].y});
                estimates.add(sum / 4);
            }
            EXPECT_GT(mean_p_value(estimates, integrand.mean),
                      sidak_level(SIGNIFICANCE, std::size(ordinals) * 3));
        }
    }
}

TEST_F(BlueNoise, PixelsBeyondTheBitsOfAnIndexHaveSequencesOfTheirOwn) {
    // With 2^28 samples a pixel an index has four bits for pixels: 16 share a sequence, the next have
    // another.
    std::vector<float> columns[4];
    std::vector<glm::uvec4> keys;
    for (std::uint32_t k = 0; k < 1 << 16; ++k) {
        const std::uint32_t ordinal = k % 16 + (k / 16) * 32;
        keys.emplace_back(3, ordinal, 5, 8);
        keys.emplace_back(3, ordinal + 16, 5, 8);
    }
    const auto all = points(keys, {shared::SAMPLER_BLUE_NOISE, 28});
    for (std::size_t k = 0; k < all.size(); ++k)
        for (int c = 0; c < 2; ++c) columns[k % 2 * 2 + static_cast<std::size_t>(c)].push_back(all[k][c]);
    for (const auto& [a, b] : {std::pair{0, 1}, {0, 2}, {1, 3}, {0, 3}})
        EXPECT_GT(independence(columns[a], columns[b]), sidak_level(SIGNIFICANCE, 4)) << a << b;
}

} // namespace
} // namespace ajar::test
