// Hashes, colours, frames and packed vectors against their definitions.
#include "core_functions.hpp"
#include "support/statistics.hpp"

#include <cmath>
#include <limits>

namespace ajar::test {
namespace {

class CoreFunction : public CoreFunctions {
  protected:
    // Unit vectors: random ones, then axes, diagonals and what lies a rounding error beside them.
    static std::vector<glm::vec4> directions() {
        std::mt19937 random(5);
        std::normal_distribution<float> normal;
        std::vector<glm::vec4> all;
        for (int k = 0; k < 100'000; ++k)
            all.emplace_back(glm::normalize(glm::vec3(normal(random), normal(random), normal(random))), 0);
        for (int x = -1; x <= 1; ++x)
            for (int y = -1; y <= 1; ++y)
                for (int z = -1; z <= 1; ++z)
                    for (const float nudge : {0.0f, 1e-7f, -1e-7f, 1e-4f, -1e-4f})
                        if (x || y || z) all.emplace_back(glm::normalize(glm::vec3(x, y, z) + nudge), 0);
        return all;
    }
};

TEST_F(CoreFunction, HashFlipsEveryBitForEveryBitWithProbabilityOneHalf) {
    constexpr std::uint32_t KEYS = 1 << 14;
    std::vector<glm::uvec4> items;
    for (std::uint32_t k = 0; k < KEYS; ++k) {
        items.emplace_back(k, 0, 0, 0);
        for (std::uint32_t bit = 0; bit < 32; ++bit) items.emplace_back(k ^ (1u << bit), 0, 0, 0);
    }
    const auto hashes = run(shared::CORE_HASH, items);
    double least = 1;
    for (std::uint32_t in = 0; in < 32; ++in) {
        for (std::uint32_t out = 0; out < 32; ++out) {
            double flips = 0;
            for (std::uint32_t k = 0; k < KEYS; ++k)
                flips += (hashes[k * 33].x ^ hashes[k * 33 + 1 + in].x) >> out & 1u;
            least = std::min(least, normal_two_sided((flips - KEYS / 2.0) / std::sqrt(KEYS / 4.0)));
        }
    }
    EXPECT_GT(least, sidak_level(SIGNIFICANCE, 32 * 32));
}

TEST_F(CoreFunction, HashesToUniformFloats) {
    std::mt19937 random(8); // salts are random bits, triangles and instances small numbers
    std::vector<glm::uvec4> items;
    for (std::uint32_t k = 0; k < 1 << 18; ++k) {
        if ((k & 511u) == 0)
            items.emplace_back(static_cast<std::uint32_t>(random()), 0, k >> 9 & 3u, 0);
        else
            items.emplace_back(items.back().x, k & 511u, items.back().z, 0);
    }
    const auto hashes = run(shared::CORE_HASH, items);
    for (const int column : {1, 3}) { // combine, salted_float
        std::vector<double> observed(1024);
        for (const glm::uvec4& h : hashes) {
            const double x = column == 1 ? h.y * 0x1p-32 : std::bit_cast<float>(h.w);
            ASSERT_TRUE(x >= 0 && x < 1);
            ++observed[static_cast<std::size_t>(x * 1024)];
        }
        EXPECT_GT(chi_square(observed, std::vector<double>(1024, 256.0)).p, sidak_level(SIGNIFICANCE, 2));
    }
}

TEST_F(CoreFunction, DecodesSrgbTo1e6OfItsDefinition) {
    std::vector<glm::vec4> items;
    for (int k = 0; k < 256; ++k) items.emplace_back(static_cast<float>(k) / 255.0f);
    for (int k = 0; k <= 10'000; ++k) items.emplace_back(static_cast<float>(k) / 10'000.0f);
    const auto results = run(shared::CORE_SRGB, items);
    for (std::size_t k = 0; k < items.size(); ++k) {
        const double c = items[k].x; // IEC 61966-2-1
        const double linear = c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
        ASSERT_NEAR(results[k].x, linear, std::min(1e-6, 1e-4 * linear + 1e-9)) << c;
    }
    EXPECT_EQ(results[0].x, 0.0f);
    EXPECT_NEAR(results[255].x, 1.0f, 5e-7f);
}

TEST_F(CoreFunction, DecodesOctahedralVectors) {
    // The documented encoding, in double.
    const auto encode = [](const glm::dvec3& n) {
        glm::dvec2 p = glm::dvec2(n) / (std::abs(n.x) + std::abs(n.y) + std::abs(n.z));
        if (n.z < 0) p = {(1 - std::abs(p.y)) * (p.x < 0 ? -1 : 1), (1 - std::abs(p.x)) * (p.y < 0 ? -1 : 1)};
        const auto snorm = [](double x) {
            return static_cast<std::uint32_t>(std::lround(x * 32767)) & 0xffffu;
        };
        return snorm(p.x) | snorm(p.y) << 16;
    };
    const auto all = directions();
    std::vector<glm::uvec4> codes;
    for (const glm::vec4& n : all) codes.emplace_back(encode(glm::dvec3(n)), 0, 0, 0);
    const auto decoded = run(shared::CORE_OCTAHEDRAL, codes);
    for (std::size_t k = 0; k < all.size(); ++k) {
        const glm::vec3 n(std::bit_cast<glm::vec4>(decoded[k]));
        // Half a step along x and y moves the point by sqrt(6) / 2 steps on a face 1 / sqrt(3) from the
        // origin.
        ASSERT_LT(glm::distance(n, glm::vec3(all[k])), std::sqrt(18.0f) / 65534 + 2e-7f);
        ASSERT_NEAR(glm::length(n), 1, 1e-6);
    }
}

TEST_F(CoreFunction, DecodesAnyOctahedralCodeToAUnitVector) {
    std::mt19937 random(6);
    std::vector<glm::uvec4> codes{
        {0, 0, 0, 0}, {0x80008000u, 0, 0, 0}, {0x7fff7fffu, 0, 0, 0}, {0x80007fffu, 0, 0, 0}};
    for (int k = 0; k < 100'000; ++k) codes.emplace_back(static_cast<std::uint32_t>(random()), 0, 0, 0);
    for (const glm::uvec4& word : run(shared::CORE_OCTAHEDRAL, codes))
        ASSERT_NEAR(glm::length(glm::vec3(std::bit_cast<glm::vec4>(word))), 1, 1e-6);
}

TEST_F(CoreFunction, FramesAreOrthonormalAndRightHanded) {
    const auto all = directions();
    const auto tangents = run(shared::CORE_FRAME, all);
    const auto bitangents = run(shared::CORE_FRAME_B, all);
    for (std::size_t k = 0; k < all.size(); ++k) {
        const glm::vec3 n(all[k]);
        const glm::vec3 t(tangents[k]);
        const glm::vec3 b(bitangents[k]);
        ASSERT_NEAR(glm::length(t), 1, 1e-6);
        ASSERT_NEAR(glm::dot(t, n), 0, 1e-6);
        ASSERT_LT(glm::distance(glm::cross(n, t), b), 2e-6f);
    }
}

TEST_F(CoreFunction, FramesTakeVectorsThereAndBack) {
    const glm::vec3 v(0.3f, -2, 0.7f);
    for (const glm::vec4& back : run(shared::CORE_FRAME_ROUND_TRIP, directions(), glm::vec4(v, 0)))
        ASSERT_LT(glm::distance(glm::vec3(back), v), 3e-6f);
}

TEST_F(CoreFunction, FramesFollowATangentAndSurviveAUselessOne) {
    const float infinity = std::numeric_limits<float>::infinity();
    auto all = directions();
    for (const float handedness : {1.0f, -1.0f}) {
        for (const glm::vec3 tangent : {glm::vec3(1, 0, 0), glm::vec3(0.6f, -3, 0.2f), glm::vec3(0),
                                        glm::vec3(NAN), glm::vec3(infinity)}) {
            for (glm::vec4& n : all) n.w = handedness;
            const auto frames = run(shared::CORE_FRAME_TANGENT, all, glm::vec4(tangent, 0));
            for (std::size_t k = 0; k < all.size(); ++k) {
                const glm::vec3 n(all[k]);
                const glm::vec3 t(frames[k]);
                ASSERT_NEAR(glm::length(t), 1, 1e-5) << tangent.x;
                ASSERT_NEAR(glm::dot(t, n), 0, 1e-3);
                ASSERT_NEAR(frames[k].w, handedness, 1e-5);
                const glm::vec3 wanted = tangent - n * glm::dot(n, tangent);
                if (glm::length(wanted) > 0.1f) {
                    ASSERT_NEAR(glm::dot(t, glm::normalize(wanted)), 1, 1e-5);
                }
            }
        }
    }
}

TEST_F(CoreFunction, ErfinvInvertsErf) {
    std::vector<glm::vec4> items;
    for (int k = -4096; k <= 4096; ++k) items.emplace_back(static_cast<float>(k) / 4097.0f);
    items.emplace_back(LARGEST_UNIFORM);
    const auto results = run(shared::CORE_ERFINV, items);
    for (std::size_t k = 0; k < items.size(); ++k)
        ASSERT_NEAR(std::erf(double(results[k].x)), items[k].x, 2e-7);
}

TEST_F(CoreFunction, AngleIsPreciseInProportion) {
    std::vector<glm::vec4> items{
        {0, 0, 0, 0}, {0, 1, 0, 0}, {0, -1, 0, 0}, {1, 0, 0, 0}, {1e-30f, -1e-30f, 0, 0}};
    for (int k = 0; k <= 400; ++k)
        for (const float sign : {-1.0f, 1.0f})
            items.emplace_back(std::pow(10.0f, -20 + 0.1f * static_cast<float>(k)), sign, 0, 0);
    const auto results = run(shared::CORE_ANGLE, items);
    for (std::size_t k = 0; k < items.size(); ++k) {
        const double expected = std::atan2(double{items[k].x}, double{items[k].y});
        ASSERT_NEAR(results[k].x, expected, 4e-7 * expected) << items[k].x << " " << items[k].y;
    }
}

TEST_F(CoreFunction, SineIsPreciseInProportionNearZero) {
    std::vector<glm::vec4> items{glm::vec4(0)};
    for (int k = 0; k <= 2048; ++k) items.emplace_back(static_cast<float>(k) * 3.14159f / 2048);
    for (int k = 1; k <= 30; ++k) items.emplace_back(std::pow(10.0f, -static_cast<float>(k)));
    const auto results = run(shared::CORE_SINE_COSINE, items);
    for (std::size_t k = 0; k < items.size(); ++k) {
        const double x = items[k].x;
        ASSERT_NEAR(results[k].x, std::sin(x), 3e-7 * std::min(std::sin(x), x) + (x > 1 ? 2e-7 : 0)) << x;
        ASSERT_NEAR(results[k].y, std::cos(x), 2e-7) << x;
    }
}

TEST_F(CoreFunction, FiniteKnowsNanAndInf) {
    const float infinity = std::numeric_limits<float>::infinity();
    const std::vector<glm::vec4> items{
        {0, 0, 0, 0},         {1e38f, -1e38f, 1e38f, 0},   {NAN, 0, 0, 0}, {0, infinity, 0, 0},
        {0, 0, -infinity, 0}, {infinity, -infinity, 0, 0}, {0, 0, NAN, 0}};
    const auto results = run(shared::CORE_FINITE, items);
    for (std::size_t k = 0; k < items.size(); ++k) EXPECT_EQ(results[k].x, k < 2 ? 1.0f : 0.0f) << k;
}

} // namespace
} // namespace ajar::test
