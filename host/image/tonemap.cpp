#include "image/tonemap.hpp"

#include "base/error.hpp"
#include "image/srgb.hpp"

#include <algorithm>
#include <array>
#include <cfloat>
#include <fmt/format.h>

namespace ajar {
namespace {

glm::vec3 linear(const glm::vec3& radiance) { return glm::min(radiance, glm::vec3(1)); }

// AgX, Troy Sobotka 2022: inset towards grey, log2 from -12.47393 to 4.026069 stops, sigmoid, outset. The
// sigmoid is the sixth-order polynomial of Benjamin Wrensch, "Minimal AgX Implementation", 2023; the matrices
// are AgX's for Rec. 709 in and out. The result is encoded for a display of exponent 2.2, which is undone
// here.
glm::vec3 agx(const glm::vec3& radiance) {
    const glm::mat3 inset(0.842479062253094f, 0.0423282422610123f, 0.0423756549057051f, // columns
                          0.0784335999999992f, 0.878468636469772f, 0.0784336f,          //
                          0.0792237451477643f, 0.0791661274605434f, 0.879142973793104f);
    const glm::mat3 outset(1.19687900512017f, -0.0528968517574562f, -0.0529716355144438f, //
                           -0.0980208811401368f, 1.15190312990417f, -0.0980434501171241f, //
                           -0.0990297440797205f, -0.0989611768448433f, 1.15107367264116f);
    constexpr float min_ev = -12.47393f, max_ev = 4.026069f;
    const glm::vec3 stops = glm::log2(glm::max(inset * radiance, glm::vec3(FLT_MIN)));
    const glm::vec3 x = (glm::clamp(stops, min_ev, max_ev) - min_ev) / (max_ev - min_ev);
    const glm::vec3 curve =
        (((((15.5f * x - 40.14f) * x + 31.96f) * x - 6.868f) * x + 0.4298f) * x + 0.1191f) * x - 0.00232f;
    return glm::pow(glm::clamp(outset * curve, 0.0f, 1.0f), glm::vec3(2.2f));
}

// ACES 1.0 reference rendering and sRGB output transform, as fitted by Stephen Hill, 2016 (in the code of
// "Baking Lab", Pettineo and Neubelt): Rec. 709 to a desaturated AP1, a rational curve, and back.
glm::vec3 aces(const glm::vec3& radiance) {
    const glm::mat3 input(0.59719f, 0.07600f, 0.02840f, // columns
                          0.35458f, 0.90834f, 0.13383f, //
                          0.04823f, 0.01566f, 0.83777f);
    const glm::mat3 output(1.60475f, -0.10208f, -0.00327f, //
                           -0.53108f, 1.10813f, -0.07276f, //
                           -0.07367f, -0.00605f, 1.07602f);
    // The curve is flat long before; the bound keeps x * x finite.
    const glm::vec3 x = glm::min(input * radiance, glm::vec3(1e6f));
    const glm::vec3 curve =
        (x * (x + 0.0245786f) - 0.000090537f) / (x * (0.983729f * x + 0.4329510f) + 0.238081f);
    return glm::clamp(output * curve, 0.0f, 1.0f);
}

// Khronos PBR Neutral, 2024: colours below 0.8 - F90 keep their hue and saturation and lose only the Fresnel
// offset of a dielectric; above, the peak is compressed towards 1 and desaturated.
glm::vec3 neutral(const glm::vec3& radiance) {
    constexpr float f90 = 0.04f, start = 0.8f - f90, desaturation = 0.15f;
    const float low = std::min({radiance.x, radiance.y, radiance.z});
    const float offset = low < 2 * f90 ? low - low * low / (4 * f90) : f90;
    const glm::vec3 color = radiance - offset;
    const float peak = std::max({color.x, color.y, color.z});
    if (peak < start) return color;
    const float compressed = 1 - (1 - start) * (1 - start) / (peak + 1 - 2 * start);
    const float grey = 1 - 1 / (desaturation * (peak - compressed) + 1);
    return glm::clamp(glm::mix(color * (compressed / peak), glm::vec3(compressed), grey), 0.0f, 1.0f);
}

constexpr std::array operators{
    TonemapOperator{"linear", "cut off at 1 (what comparisons expect)", linear},
    TonemapOperator{"agx", "AgX: highlights fade to white without changing hue (Sobotka)", agx},
    TonemapOperator{"aces", "ACES film look, high contrast (Hill's fit)", aces},
    TonemapOperator{"neutral", "Khronos PBR Neutral: true base colours", neutral},
};

float sanitize(float value) {
    return value > 0 ? std::min(value, FLT_MAX) : 0.0f; // NaN compares false
}

} // namespace

std::span<const TonemapOperator> tonemap_operators() { return operators; }

const TonemapOperator& find_tonemap(std::string_view name) {
    std::string names;
    for (const TonemapOperator& op : operators) {
        if (op.name == name) return op;
        names += fmt::format("{}{}", names.empty() ? "" : ", ", op.name);
    }
    throw Error(fmt::format("tonemap '{}': unknown (there are {})", name, names));
}

glm::vec3 Tonemap::operator()(const glm::vec3& radiance) const {
    const float scale = std::exp2(exposure);
    const glm::vec3 exposed(sanitize(radiance.x * scale), sanitize(radiance.y * scale),
                            sanitize(radiance.z * scale));
    return srgb_encode(op->apply(exposed));
}

} // namespace ajar
