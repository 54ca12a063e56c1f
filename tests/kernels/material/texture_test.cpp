// Textures against a reference in double that wraps whole texel numbers: every wrap, filter, size and
// transform.
#include "material_functions.hpp"

#include <cmath>
#include <limits>
#include <random>

namespace ajar::test {
namespace {

class Texture : public MaterialFunctions {};

TestTexture noise(std::uint32_t width, std::uint32_t height, std::uint32_t flags, std::uint32_t seed) {
    std::mt19937 random(seed);
    TestTexture texture{width, height, {}, flags};
    for (std::uint32_t k = 0; k < width * height; ++k) {
        const auto bits = static_cast<std::uint32_t>(random());
        texture.texels.emplace_back(bits & 255u, bits >> 8 & 255u, bits >> 16 & 255u, bits >> 24);
    }
    return texture;
}

std::vector<glm::vec4> coordinates(std::size_t count, float lower, float upper, std::uint32_t seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> uniform(lower, upper);
    std::vector<glm::vec4> uv(count);
    for (glm::vec4& item : uv) item = {uniform(random), uniform(random), uniform(random), uniform(random)};
    return uv;
}

// Where texel number i of an endless picture is found, by glTF's (OpenGL's) words for each wrap.
std::int64_t wrapped(std::int64_t i, std::int64_t size, std::uint32_t wrap) {
    const auto modulo = [](std::int64_t a, std::int64_t b) { return (a % b + b) % b; };
    if (wrap == shared::WRAP_CLAMP) return std::clamp<std::int64_t>(i, 0, size - 1);
    if (wrap == shared::WRAP_REPEAT) return modulo(i, size);
    const std::int64_t at = modulo(i, 2 * size);
    return at < size ? at : 2 * size - 1 - at;
}

glm::dvec4 texel(const TestTexture& t, std::int64_t x, std::int64_t y) {
    const auto column = static_cast<std::size_t>(wrapped(x, t.width, t.flags & 3u));
    const auto row =
        static_cast<std::size_t>(wrapped(y, t.height, t.flags >> shared::TEXTURE_WRAP_V_SHIFT & 3u));
    glm::dvec4 value = glm::dvec4(t.texels[row * t.width + column]) / 255.0;
    if ((t.flags & shared::TEXTURE_SRGB) == 0) return value;
    for (int channel = 0; channel < 3; ++channel) {
        const double c = value[channel];
        value[channel] = c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
    }
    return value;
}

glm::dvec4 reference(const TestTexture& t, const glm::vec4& item) {
    const glm::dvec3 uv(t.flags & shared::TEXTURE_UV1 ? glm::vec2(item.z, item.w) : glm::vec2(item), 1);
    const double x = glm::dot(glm::dvec3(t.row_u), uv) * t.width;
    const double y = glm::dot(glm::dvec3(t.row_v), uv) * t.height;
    const auto floor = [](double a) { return static_cast<std::int64_t>(std::floor(a)); };
    if (t.flags & shared::TEXTURE_NEAREST) return texel(t, floor(x), floor(y));
    const std::int64_t i = floor(x - 0.5);
    const std::int64_t j = floor(y - 0.5);
    const glm::dvec4 top = glm::mix(texel(t, i, j), texel(t, i + 1, j), x - 0.5 - double(i));
    const glm::dvec4 bottom = glm::mix(texel(t, i, j + 1), texel(t, i + 1, j + 1), x - 0.5 - double(i));
    return glm::mix(top, bottom, y - 0.5 - double(j));
}

// Nearer to a texel's edge than rounding in float decides (nearest only).
bool ambiguous(const TestTexture& t, const glm::vec4& item) {
    if ((t.flags & shared::TEXTURE_NEAREST) == 0) return false;
    const glm::dvec3 uv(t.flags & shared::TEXTURE_UV1 ? glm::vec2(item.z, item.w) : glm::vec2(item), 1);
    const double x = glm::dot(glm::dvec3(t.row_u), uv) * t.width;
    const double y = glm::dot(glm::dvec3(t.row_v), uv) * t.height;
    return std::abs(x - std::round(x)) < 1e-4 || std::abs(y - std::round(y)) < 1e-4;
}

void expect_reference(const TestTexture& t, const std::vector<glm::vec4>& uv,
                      const std::vector<glm::vec4>& samples) {
    for (std::size_t k = 0; k < uv.size(); ++k) {
        if (ambiguous(t, uv[k])) continue;
        const glm::dvec4 expected = reference(t, uv[k]);
        for (int channel = 0; channel < 4; ++channel)
            ASSERT_NEAR(samples[k][channel], expected[channel], 1e-4) << uv[k].x << " " << uv[k].y;
    }
}

TEST_F(Texture, WrapsAndFiltersLikeTheReference) {
    const auto uv = coordinates(5000, -3, 3, 1);
    for (const glm::uvec2 size : {glm::uvec2(7, 5), glm::uvec2(1, 1), glm::uvec2(1, 8), glm::uvec2(32, 3)}) {
        for (std::uint32_t wrap_u = 0; wrap_u < 3; ++wrap_u) {
            for (std::uint32_t wrap_v = 0; wrap_v < 3; ++wrap_v) {
                for (const std::uint32_t filter : {0u, std::uint32_t(shared::TEXTURE_NEAREST)}) {
                    SCOPED_TRACE(testing::Message() << size.x << "x" << size.y << " wraps " << wrap_u << " "
                                                    << wrap_v << " filter " << filter);
                    const std::uint32_t wraps = wrap_u | wrap_v << shared::TEXTURE_WRAP_V_SHIFT;
                    const TestTexture texture = noise(size.x, size.y, wraps | filter, 2);
                    expect_reference(texture, uv, sample(texture, uv));
                }
            }
        }
    }
}

TEST_F(Texture, DecodesSrgbBeforeItFiltersAndNeverAlpha) {
    const auto uv = coordinates(5000, -1, 2, 3);
    const TestTexture texture = noise(16, 16, shared::TEXTURE_SRGB, 4);
    expect_reference(texture, uv, sample(texture, uv));
}

TEST_F(Texture, TakesTheSecondCoordinatesAndTheTransform) {
    const auto uv = coordinates(5000, -1, 2, 5);
    TestTexture texture = noise(8, 8, shared::TEXTURE_UV1, 6);
    texture.row_u = {0.8f, -1.2f, 0.3f};
    texture.row_v = {1.5f, 0.4f, -0.7f};
    expect_reference(texture, uv, sample(texture, uv));
}

TEST_F(Texture, HasItsTexelsInTheMiddlesOfTheirCellsAndRowZeroAtTheTop) {
    for (const std::uint32_t filter : {0u, std::uint32_t(shared::TEXTURE_NEAREST)}) {
        const TestTexture texture = noise(8, 4, filter, 7);
        std::vector<glm::vec4> uv;
        for (std::uint32_t y = 0; y < 4; ++y)
            for (std::uint32_t x = 0; x < 8; ++x)
                uv.emplace_back((float(x) + 0.5f) / 8, (float(y) + 0.5f) / 4, 0, 0);
        const auto samples = sample(texture, uv);
        for (std::size_t k = 0; k < uv.size(); ++k)
            ASSERT_LT(glm::distance(samples[k], glm::vec4(texture.texels[k]) / 255.0f), 1e-6f);
    }
}

TEST_F(Texture, OfOneColourIsThatColourEverywhereWhateverTheCoordinates) {
    const float infinity = std::numeric_limits<float>::infinity();
    std::vector<glm::vec4> uv;
    const float odd[] = {0,   -0.0f,    1,         -1e-9f,      1e-30f,        0.99999994f,
                         -1,  5,        1e6f,      -1e6f,       1e9f,          -3e38f,
                         NAN, infinity, -infinity, 16777217.0f, 2147483648.0f, -4294967296.0f};
    for (const float u : odd)
        for (const float v : odd) uv.emplace_back(u, v, v, u);
    for (std::uint32_t flags = 0; flags < 128; ++flags) {
        const bool known = (flags & 3u) < 3 && (flags >> shared::TEXTURE_WRAP_V_SHIFT & 3u) < 3;
        if (!known || (flags & shared::TEXTURE_SRGB)) continue;
        // A frame of other texels in front and behind shows any step outside.
        TestTexture texture{3, 2, std::vector<Texel>(6, Texel(51, 102, 204, 255)), flags};
        TestMaterials scene;
        scene.textures = {noise(4, 4, 0, 8), texture, noise(4, 4, 0, 9)};
        const auto words = run(shared::MATERIAL_TEXTURE, scene, 1, uv);
        for (std::size_t k = 0; k < uv.size(); ++k)
            ASSERT_LT(glm::distance(words[k * shared::MATERIAL_WORDS], glm::vec4(0.2f, 0.4f, 0.8f, 1)), 1e-6f)
                << uv[k].x << " " << uv[k].y << " flags " << flags;
    }
}

TEST_F(Texture, ThatIsNotThereIsWhite) {
    const TestMaterials scene; // no texture at all
    for (const std::uint32_t k : {0u, 1u}) {
        const auto words =
            run(shared::MATERIAL_TEXTURE, scene, shared::NO_TEXTURE, coordinates(100, -2, 2, 10 + k));
        for (std::size_t i = 0; i < words.size(); i += shared::MATERIAL_WORDS)
            ASSERT_EQ(words[i], glm::vec4(1));
    }
}

} // namespace
} // namespace ajar::test
