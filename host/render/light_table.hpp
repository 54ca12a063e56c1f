// All lights of a scene as the device reads them, with the power sampler's probabilities.
// Powers are in watts of luminance-weighted light: what a light sends into the scene (Pharr et al. 2023,
// section 12.6.2).
#pragma once

#include "render/light_tree.hpp"
#include "scene/scene.hpp"
#include "shaders/shared/frame.glsl.h"
#include "shaders/shared/geometry.glsl.h"
#include "shaders/shared/light.glsl.h"

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace ajar {

// A triangle that emits, in world space. Vertices are counter-clockwise as its front face sees them.
struct EmissiveTriangle {
    glm::vec3 p0{0};
    glm::vec3 p1{0};
    glm::vec3 p2{0};
    std::uint32_t triangle = 0; // index in leaf order
    std::uint32_t material = 0; // Scene::materials
    glm::vec3 emission{0};      // mean radiance, W/(m^2 sr): see EmissionMeans
    bool two_sided = false;
    bool textured =
        false;      // emission differs from point to point (texture, or alpha MASK or BLEND): looked up there
    float area = 0; // m^2
};

// A mesh that emits as a sphere, outwards.
struct EmissiveSphere {
    std::uint32_t instance = 0; // Scene::instances
    glm::vec3 center{0};        // world, metres
    float radius = 0;
    glm::vec3 emission{0}; // radiance, W/(m^2 sr)
};

struct LightTable {
    // Triangles in the order given; points, spots and directional lights without extent; soft lights:
    // spheres in the order given, suns, lamps with a radius; the environment.
    std::vector<shared::LightRecord> lights;
    std::vector<shared::AliasEntry> alias;   // over all lights by power
    std::vector<shared::AliasEntry> distant; // over those without a place, by irradiance
    float distant_irradiance = 0;            // luminance, W/m^2: of all of those, facing each
    LightTree tree;                          // over the others
    std::vector<double> powers;              // per light, W
    std::uint32_t environment_light = shared::NO_LIGHT;
    std::uint32_t soft_first = 0; // the soft lights that rays meet: FrameRecord::soft_first
    std::uint32_t soft_count = 0; // at most MAX_SOFT_LIGHTS; those behind are found by light sampling alone
    std::uint32_t features = 0;   // FEATURE_* bits of the kinds that are there

    // BIND_LIGHTS: lights, alias, distant, tree's nodes and trails.
    std::vector<glm::uvec4> words() const;
    // Where those parts begin, and the other fields about lights.
    void describe(shared::FrameRecord& frame) const;
};

// scene_radius: of a sphere around the scene, metres; the environment and directional lights shine through
// its disk. At most MAX_SOFT_LIGHTS spheres. environment_share: of the environment's light, that which light
// sampling is to find (EnvironmentTable::share); it counts with no more. Lights without power have a pmf of
// 0, but uniform picking still finds them. Throws Error for too many lights.
LightTable build_light_table(const Scene& scene, std::span<const EmissiveTriangle> triangles,
                             float scene_radius, std::span<const EmissiveSphere> spheres = {},
                             double environment_share = 1);

// Watts, luminance-weighted.
double light_power(const EmissiveTriangle& triangle);
double light_power(const EmissiveSphere& sphere);
double light_power(const Light& light, float scene_radius);
double light_power(const Environment& environment, float scene_radius);

// As the light tree sees a light that is somewhere.
LightBounds light_bounds(const EmissiveTriangle& triangle);
LightBounds light_bounds(const EmissiveSphere& sphere);
LightBounds light_bounds(const Light& light);
// Of a light that is nowhere: what it brings to a surface that faces it, W/m^2, luminance.
double distant_irradiance(const Light& light);
double distant_irradiance(const Environment& environment);

} // namespace ajar
