#include "image/flip.hpp"

#include "image/convolve.hpp"

#include <algorithm>
#include <cassert>
#include <cfloat>
#include <cmath>
#include <glm/glm.hpp>
#include <span>

namespace ajar {
namespace {

// The metric's constants; the names are the paper's (HPG 2020, sections 4 and 5).
constexpr float q_color = 0.7f, p_color = 0.4f, p_target = 0.95f, q_feature = 0.5f;
constexpr double feature_width_degrees = 0.082;

// Conversions between linear RGB, the opponent space YCxCz (linear in XYZ, in which filters may average) and
// L*a*b*.
class ColorSpaces {
  public:
    ColorSpaces() {
        // CIE XYZ of the Rec. 709 primaries with D65 white, as exact fractions; columns.
        glm::dmat3 relative(10135552.0 / 24577794, 2613072.0 / 12288897, 1425312.0 / 73733382, //
                            8788810.0 / 24577794, 8788810.0 / 12288897, 8788810.0 / 73733382,  //
                            4435075.0 / 24577794, 887015.0 / 12288897, 70074185.0 / 73733382);
        const glm::dvec3 white = relative * glm::dvec3(1);
        for (int c = 0; c < 3; ++c) relative[c] /= white;
        to_relative_ = glm::mat3(relative);
        from_relative_ = glm::mat3(glm::inverse(relative));
    }
    glm::vec3 ycxcz(const glm::vec3& rgb) const {
        const glm::vec3 n = to_relative_ * rgb;
        return {116 * n.y - 16, 500 * (n.x - n.y), 200 * (n.y - n.z)};
    }
    glm::vec3 rgb(const glm::vec3& ycxcz) const {
        const float y = (ycxcz.x + 16) / 116;
        return from_relative_ * glm::vec3(y + ycxcz.y / 500, y, y - ycxcz.z / 200);
    }
    // L*a*b* with the Hunt effect: a and b fade with L.
    glm::vec3 hunt_lab(const glm::vec3& rgb) const {
        const glm::vec3 n = to_relative_ * rgb;
        const float x = lab_curve(n.x), y = lab_curve(n.y), z = lab_curve(n.z);
        const float lightness = 116 * y - 16;
        return {lightness, 0.01f * lightness * 500 * (x - y), 0.01f * lightness * 200 * (y - z)};
    }

  private:
    static float lab_curve(float t) {
        constexpr float delta = 6.0f / 29;
        return t > delta * delta * delta ? std::cbrt(t) : t / (3 * delta * delta) + 4.0f / 29;
    }
    glm::mat3 to_relative_{1}, from_relative_{1}; // linear RGB to XYZ relative to white, and back
};

// HyAB: city-block in lightness, Euclidean in chroma (Abasi, Tehran, Fairchild 2020).
float hyab(const glm::vec3& a, const glm::vec3& b) {
    return std::abs(a.x - b.x) + std::hypot(a.y - b.y, a.z - b.z);
}

// A Gaussian of the eye's contrast sensitivity: a sqrt(pi / b) exp(-pi^2 d^2 / b), d in degrees.
struct Sensitivity {
    double a, b;
};

// The taps of one of the Gaussians whose sum, normalized, is a channel's filter. Each Gaussian separates into
// equal rows and columns, so a tap is the root of the weight.
std::vector<std::vector<float>> sensitivity_taps(std::span<const Sensitivity> gaussians,
                                                 double pixels_per_degree) {
    constexpr double pi = 3.14159265358979323846;
    constexpr double widest =
        0.04; // the largest b of all channels sets the radius: three standard deviations
    const int radius = static_cast<int>(std::ceil(3 * std::sqrt(widest / (2 * pi * pi)) * pixels_per_degree));
    std::vector<std::vector<double>> taps;
    double total = 0;
    for (const Sensitivity& g : gaussians) {
        double sum = 0;
        for (int i = -radius; i <= radius; ++i) {
            const double d = i / pixels_per_degree;
            const double weight = std::sqrt(g.a * std::sqrt(pi / g.b)) * std::exp(-pi * pi * d * d / g.b);
            if (i == -radius) taps.emplace_back();
            taps.back().push_back(weight);
            sum += weight;
        }
        total += sum * sum;
    }
    std::vector<std::vector<float>> normalized;
    for (const auto& gaussian : taps) {
        auto& row = normalized.emplace_back();
        for (const double tap : gaussian) row.push_back(static_cast<float>(tap / std::sqrt(total)));
    }
    return normalized;
}

// A Gaussian and its first two derivatives, with positive and negative weights that each sum to one.
struct FeatureTaps {
    std::vector<float> smooth, edge, point;
};

FeatureTaps feature_taps(double pixels_per_degree) {
    const double deviation = 0.5 * feature_width_degrees * pixels_per_degree;
    const int radius = static_cast<int>(std::ceil(3 * deviation));
    const auto normalized = [&](auto&& weight) {
        double positive = 0, negative = 0;
        for (int i = -radius; i <= radius; ++i) (weight(i) > 0 ? positive : negative) += std::abs(weight(i));
        std::vector<float> taps;
        for (int i = -radius; i <= radius; ++i)
            taps.push_back(
                static_cast<float>(weight(i) / (weight(i) > 0 ? positive : std::max(negative, DBL_MIN))));
        return taps;
    };
    const auto gaussian = [=](int i) { return std::exp(-i * i / (2 * deviation * deviation)); };
    return {normalized(gaussian), normalized([&](int i) { return -i * gaussian(i); }),
            normalized([&](int i) { return (i * i / (deviation * deviation) - 1) * gaussian(i); })};
}

// What the metric compares of one image.
struct Percept {
    std::vector<glm::vec3> lab; // filtered by contrast sensitivity, Hunt-adjusted
    Plane edge, point;          // strengths of edges and points in the achromatic channel
};

class Flip {
  public:
    explicit Flip(float pixels_per_degree) : features_(feature_taps(pixels_per_degree)) {
        constexpr Sensitivity achromatic[] = {{1, 0.0047}}, red_green[] = {{1, 0.0053}},
                              blue_yellow[] = {{34.1, 0.04}, {13.5, 0.025}};
        sensitivity_ = {sensitivity_taps(achromatic, pixels_per_degree),
                        sensitivity_taps(red_green, pixels_per_degree),
                        sensitivity_taps(blue_yellow, pixels_per_degree)};
        const float most = hyab(spaces_.hunt_lab({0, 1, 0}), spaces_.hunt_lab({0, 0, 1}));
        largest_ = std::pow(most, q_color);
    }

    // `display` in [0, 1].
    Percept perceive(const ColorPlanes& display) const {
        const std::uint32_t w = display.width, h = display.height;
        std::array<Plane, 3> opponent;
        for (Plane& plane : opponent) plane.resize(std::size_t{w} * h);
        for (std::size_t i = 0; i < opponent[0].size(); ++i) {
            const glm::vec3 c =
                spaces_.ycxcz({display.channel[0][i], display.channel[1][i], display.channel[2][i]});
            for (int k = 0; k < 3; ++k) opponent[static_cast<std::size_t>(k)][i] = c[k];
        }
        std::array<Plane, 3> seen;
        for (std::size_t c = 0; c < 3; ++c) {
            seen[c].resize(opponent[c].size());
            for (const auto& taps : sensitivity_[c]) add_convolved(opponent[c], w, h, taps, taps, seen[c]);
        }
        Percept percept;
        percept.lab.reserve(seen[0].size());
        for (std::size_t i = 0; i < seen[0].size(); ++i) {
            const glm::vec3 rgb = spaces_.rgb({seen[0][i], seen[1][i], seen[2][i]});
            percept.lab.push_back(spaces_.hunt_lab(glm::clamp(rgb, 0.0f, 1.0f)));
        }
        for (float& y : opponent[0]) y = (y + 16) / 116;
        percept.edge = strength(opponent[0], w, h, features_.edge);
        percept.point = strength(opponent[0], w, h, features_.point);
        return percept;
    }

    float error(const Percept& reference, const Percept& test, std::size_t i) const {
        const float knee = p_color * largest_;
        float color = std::pow(hyab(reference.lab[i], test.lab[i]), q_color);
        color = color < knee ? p_target * color / knee
                             : p_target + (color - knee) / (largest_ - knee) * (1 - p_target);
        const float edge = std::abs(reference.edge[i] - test.edge[i]);
        const float point = std::abs(reference.point[i] - test.point[i]);
        const float feature = std::pow(std::max(edge, point) / std::sqrt(2.0f), q_feature);
        return std::clamp(std::pow(color, 1 - feature), 0.0f, 1.0f);
    }

  private:
    // Magnitude of the responses along x and along y.
    Plane strength(const Plane& y, std::uint32_t w, std::uint32_t h, const std::vector<float>& taps) const {
        Plane across(y.size()), down(y.size());
        add_convolved(y, w, h, taps, features_.smooth, across);
        add_convolved(y, w, h, features_.smooth, taps, down);
        for (std::size_t i = 0; i < y.size(); ++i) across[i] = std::hypot(across[i], down[i]);
        return across;
    }

    ColorSpaces spaces_;
    std::array<std::vector<std::vector<float>>, 3> sensitivity_; // of Y, Cx, Cz
    FeatureTaps features_;
    float largest_; // colour error between the display's green and blue
};

// The fit of ACES by Krzysztof Narkowicz (2015) with exposure 0.6, as HDR-FLIP uses it: (n2 x^2 + n1 x) / (d2
// x^2 + d1 x + d0).
constexpr float n2 = 0.6f * 0.6f * 2.51f, n1 = 0.6f * 0.03f, d2 = 0.6f * 0.6f * 2.43f, d1 = 0.6f * 0.59f,
                d0 = 0.14f;

template <class Curve> ColorPlanes mapped(const ColorPlanes& image, Curve&& curve) {
    ColorPlanes result = image;
    for (Plane& plane : result.channel)
        for (float& value : plane) value = curve(value);
    return result;
}

} // namespace

Plane flip_ldr(const ColorPlanes& reference, const ColorPlanes& test, float pixels_per_degree) {
    assert(reference.width == test.width && reference.height == test.height);
    const auto cut = [](float value) { return std::clamp(value, 0.0f, 1.0f); };
    const Flip flip(pixels_per_degree);
    const Percept a = flip.perceive(mapped(reference, cut)), b = flip.perceive(mapped(test, cut));
    Plane error(a.lab.size());
    for (std::size_t i = 0; i < error.size(); ++i) error[i] = flip.error(a, b, i);
    return error;
}

ExposureRange flip_exposures(const ColorPlanes& reference) {
    Plane luminance(reference.channel[0].size());
    for (std::size_t i = 0; i < luminance.size(); ++i)
        luminance[i] = std::max(0.0f, 0.2126f * reference.channel[0][i] + 0.7152f * reference.channel[1][i] +
                                          0.0722f * reference.channel[2][i]);
    const float highest = *std::max_element(luminance.begin(), luminance.end());
    if (!(highest > 0)) return {};
    const auto middle = luminance.begin() + static_cast<std::ptrdiff_t>(luminance.size() / 2);
    std::nth_element(luminance.begin(), middle, luminance.end());
    // Solve curve(x) = 0.85 for the positive x.
    constexpr float level = 0.85f;
    constexpr float qa = n2 - level * d2, qb = n1 - level * d1, qc = -level * d0;
    const float x = (-qb + std::sqrt(qb * qb - 4 * qa * qc)) / (2 * qa);
    ExposureRange range;
    range.start = std::log2(x / highest);
    range.stop = std::log2(x / std::max(*middle, FLT_EPSILON)); // mostly black: as the authors' program does
    range.stop = std::max(range.start, range.stop);
    range.count = std::max(2, static_cast<int>(std::ceil(range.stop - range.start)));
    return range;
}

Plane flip_hdr(const ColorPlanes& reference, const ColorPlanes& test, float pixels_per_degree) {
    assert(reference.width == test.width && reference.height == test.height);
    const Flip flip(pixels_per_degree);
    const ExposureRange range = flip_exposures(reference);
    Plane worst(reference.channel[0].size(), 0.0f);
    for (int e = 0; e < range.count; ++e) {
        const float step =
            range.count > 1 ? (range.stop - range.start) / static_cast<float>(range.count - 1) : 0;
        const float scale = std::exp2(range.start + step * static_cast<float>(e));
        const auto curve = [scale](float value) {
            const float x =
                std::clamp(value * scale, 0.0f, 1e6f); // saturated long before; x * x stays finite
            return std::clamp(x * (n2 * x + n1) / (x * (d2 * x + d1) + d0), 0.0f, 1.0f);
        };
        const Percept a = flip.perceive(mapped(reference, curve)), b = flip.perceive(mapped(test, curve));
        for (std::size_t i = 0; i < worst.size(); ++i) worst[i] = std::max(worst[i], flip.error(a, b, i));
    }
    return worst;
}

} // namespace ajar
