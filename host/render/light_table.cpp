// Records and powers of lights.
#include "render/light_table.hpp"

#include "render/alias_table.hpp"
#include "render/environment_table.hpp"
#include "render/luminance.hpp"
#include "shaders/shared/specialization.glsl.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <numbers>

namespace ajar {
namespace {

using std::numbers::pi;

// angle scale and offset of KHR_lights_punctual's recommended spot profile.
glm::vec2 spot_scale_offset(const Light& light) {
    const float outer = std::cos(light.outer_cone_angle);
    const float scale = 1.0f / std::max(0.001f, std::cos(light.inner_cone_angle) - outer);
    return {scale, -outer * scale};
}

double positive(double x) { return std::isfinite(x) && x > 0 ? x : 0; }

// A scene without extent still gets its light.
double disk_area(float scene_radius) {
    return pi * (scene_radius > 0 ? double{scene_radius} * scene_radius : 1.0);
}

shared::LightRecord triangle_record(const EmissiveTriangle& t) {
    shared::LightRecord record{};
    record.p0 = t.p0;
    record.p1 = t.p1;
    record.p2 = t.p2;
    record.kind = shared::LIGHT_TRIANGLE | (t.two_sided ? shared::LIGHT_TWO_SIDED : 0u) |
                  (t.textured ? shared::LIGHT_TEXTURED : 0u);
    record.triangle = t.triangle;
    record.radiance = t.emission;
    record.area = t.area;
    return record;
}

shared::LightRecord punctual_record(const Light& light) {
    shared::LightRecord record{};
    record.p0 = light.position;
    record.p1 = light.direction;
    record.p2.x = light.range > 0 ? 1 / (light.range * light.range) : 0;
    record.radiance = light.intensity;
    record.kind = shared::LIGHT_POINT;
    if (light.kind == LightKind::directional) record.kind = shared::LIGHT_DIRECTIONAL;
    if (light.kind == LightKind::spot) {
        record.kind = shared::LIGHT_SPOT;
        const glm::vec2 profile = spot_scale_offset(light);
        record.p2.y = profile.x;
        record.p2.z = profile.y;
    }
    return record;
}

} // namespace

double light_power(const EmissiveTriangle& t) {
    return positive(pi * t.area * luminance(t.emission) * (t.two_sided ? 2 : 1));
}

double light_power(const Light& light, float scene_radius) {
    const double intensity = luminance(light.intensity);
    if (light.kind == LightKind::directional) return positive(intensity * disk_area(scene_radius));
    if (light.kind == LightKind::point) return positive(4 * pi * intensity);
    // 2 pi times the integral over c = cos from outer to 1 of min(1, (c - outer) scale)^2.
    const double outer = std::cos(light.outer_cone_angle);
    const double scale = spot_scale_offset(light).x;
    const double inner = std::min(1.0, outer + 1 / scale);
    const double ramp = (inner - outer) * scale;
    return positive(2 * pi * intensity * (ramp * ramp * ramp / (3 * scale) + (1 - inner)));
}

double light_power(const Environment& environment, float scene_radius) {
    return positive(4 * pi * luminance(mean_radiance(environment)) * disk_area(scene_radius));
}

LightTable build_light_table(const Scene& scene, std::span<const EmissiveTriangle> triangles,
                             float scene_radius) {
    LightTable table;
    for (const EmissiveTriangle& t : triangles) {
        table.lights.push_back(triangle_record(t));
        table.powers.push_back(light_power(t));
        table.features |= shared::FEATURE_EMISSIVE_TRIANGLES;
    }
    for (const Light& light : scene.lights) {
        table.lights.push_back(punctual_record(light));
        table.powers.push_back(light_power(light, scene_radius));
        table.features |= shared::FEATURE_PUNCTUAL_LIGHTS;
    }
    if (scene.environment) {
        shared::LightRecord record{};
        record.kind = shared::LIGHT_ENVIRONMENT;
        record.radiance = scene.environment->scale;
        table.environment_light = static_cast<std::uint32_t>(table.lights.size());
        table.lights.push_back(record);
        table.powers.push_back(light_power(*scene.environment, scene_radius));
        table.features |= scene.environment->radiance.empty() ? shared::FEATURE_CONSTANT_ENVIRONMENT
                                                              : shared::FEATURE_ENVIRONMENT_MAP;
    }
    AliasTable alias = build_alias_table(table.powers);
    for (std::size_t i = 0; i < table.lights.size(); ++i) table.lights[i].power_pmf = alias.pmf[i];
    table.alias = std::move(alias.entries);
    return table;
}

std::uint32_t LightTable::alias_first() const {
    return static_cast<std::uint32_t>(lights.size()) * shared::LIGHT_TEXELS;
}

std::vector<glm::uvec4> LightTable::words() const {
    static_assert(sizeof(shared::AliasEntry) == sizeof(glm::uvec4));
    std::vector<glm::uvec4> result(lights.size() * shared::LIGHT_TEXELS + alias.size());
    if (!lights.empty())
        std::memcpy(result.data(), lights.data(), lights.size() * sizeof(shared::LightRecord));
    std::memcpy(result.data() + alias_first(), alias.data(), alias.size() * sizeof(shared::AliasEntry));
    return result;
}

} // namespace ajar
