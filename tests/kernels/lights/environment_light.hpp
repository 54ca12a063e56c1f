// Environment maps under test, what a direction looks up in them, and the functions of the environment's
// light run on them.
#pragma once

#include "light_functions.hpp"
#include "support/scene_builder.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ajar::test {

inline constexpr double PI = std::numbers::pi;

// A place in a map.
struct Texel {
    double x = 0; // columns from the left
    double y = 0; // rows from the top
};

// u = atan2(z, x) / 2 pi + 1/2, v = 0 at +Y; `rotation` turns the map about +Y.
inline Texel texel_of(const Environment& e, glm::dvec3 world) {
    const double c = std::cos(double{e.rotation});
    const double s = std::sin(double{e.rotation});
    // A rotation by r about +Y takes z to x; the map sees the direction turned back.
    const glm::dvec3 d(c * world.x - s * world.z, world.y, s * world.x + c * world.z);
    return {(std::atan2(d.z, d.x) / (2 * PI) + 0.5) * e.width,
            std::atan2(std::hypot(d.x, d.z), d.y) / PI * e.height};
}

inline glm::dvec3 lookup(const Environment& e, Texel t) {
    const double fx = std::floor(t.x - 0.5);
    const double fy = std::floor(t.y - 0.5);
    const auto at = [&](double x, double y) {
        const auto i = (static_cast<std::int64_t>(x) + e.width) % e.width;
        const auto j = std::clamp<std::int64_t>(static_cast<std::int64_t>(y), 0, e.height - 1);
        return glm::dvec3(e.radiance[static_cast<std::size_t>(j) * e.width + static_cast<std::size_t>(i)]);
    };
    const double wx = t.x - 0.5 - fx;
    const double wy = t.y - 0.5 - fy;
    return glm::dvec3(e.scale) * glm::mix(glm::mix(at(fx, fy), at(fx + 1, fy), wx),
                                          glm::mix(at(fx, fy + 1), at(fx + 1, fy + 1), wx), wy);
}

inline Environment black(std::uint32_t width, std::uint32_t height) {
    Environment e;
    e.width = width;
    e.height = height;
    e.radiance.resize(std::size_t{width} * height, glm::vec3(0));
    return e;
}

// A dim sky above, black below, a sun of a hundred thousand times the sky in one texel.
inline Environment sunny(std::uint32_t width, std::uint32_t height) {
    Environment e = black(width, height);
    for (std::uint32_t y = 0; y < height / 2; ++y)
        for (std::uint32_t x = 0; x < width; ++x)
            e.radiance[std::size_t{y} * width + x] =
                glm::vec3(0.2f, 0.3f, 0.5f + 0.5f * static_cast<float>(x) / static_cast<float>(width));
    e.radiance[std::size_t{height / 4} * width + width / 3] = glm::vec3(1e5f, 9e4f, 8e4f);
    e.scale = glm::vec3(1, 2, 0.5f);
    e.rotation = 0.7f;
    return e;
}

// What a place in the map that is off by 1e-5 texels, as float directions are, does to a lookup.
inline double slack(const Environment& e, Texel t) {
    const bool by_the_sun = e.width == 64 && std::abs(t.x - 64 / 3 - 0.5) < 1.1 && std::abs(t.y - 8.5) < 1.1;
    return by_the_sun ? 20 : 1e-4;
}

// Smooth, coloured, nowhere black; odd sizes.
inline Environment smooth(std::uint32_t width, std::uint32_t height) {
    Environment e = black(width, height);
    for (std::uint32_t y = 0; y < height; ++y)
        for (std::uint32_t x = 0; x < width; ++x) {
            const glm::vec3 d = environment_direction(x, y, width, height);
            e.radiance[std::size_t{y} * width + x] = glm::vec3(1.1f + d.x, 1.1f + d.y, 1.1f + d.z * d.x);
        }
    e.rotation = -2;
    return e;
}

inline std::vector<Environment> maps() {
    return {sunny(64, 32), smooth(37, 19), smooth(1, 1), smooth(2, 1),
            smooth(4099, 5)}; // the last has cells of 4 x 4
}

class EnvironmentLight : public LightFunctions {
  protected:
    static Lighting with(const Environment& environment, EnvironmentDensity density) {
        Lighting lighting;
        lighting.scene.environment = environment;
        lighting.environment_density = density;
        return lighting;
    }
    static std::vector<LightItem> look(const Environment& environment,
                                       const std::vector<glm::dvec3>& directions,
                                       EnvironmentDensity density = EnvironmentDensity::radiance) {
        std::vector<LightItem> items(directions.size());
        for (std::size_t i = 0; i < items.size(); ++i) items[i].direction = glm::vec3(directions[i]);
        return run(shared::LIGHTS_ENVIRONMENT, with(environment, density), std::move(items));
    }
    static std::vector<LightItem> samples(const Environment& environment, std::size_t count = 400000,
                                          EnvironmentDensity density = EnvironmentDensity::radiance) {
        return sample(with(environment, density), 0, glm::vec3(1, 2, 3), count, 21);
    }
    static glm::dvec3 direction(const Environment& e, double x, double y) {
        const double phi = (x / e.width - 0.5) * 2 * PI;
        const double theta = y / e.height * PI;
        const glm::dvec3 d(std::sin(theta) * std::cos(phi), std::cos(theta), std::sin(theta) * std::sin(phi));
        const double c = std::cos(double{e.rotation});
        const double s = std::sin(double{e.rotation});
        return {c * d.x + s * d.z, d.y, c * d.z - s * d.x};
    }
};

} // namespace ajar::test
