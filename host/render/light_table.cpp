// Records, powers and bounds of lights.
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

// The distribution over lights that are nowhere; their share goes into LightRecord::distant_pmf.
void add_distant(const std::vector<double>& weights, LightTable& table) {
    std::vector<double> irradiances;
    std::vector<std::uint32_t> lights;
    for (std::uint32_t i = 0; i < weights.size(); ++i) {
        if (!(weights[i] > 0)) continue;
        irradiances.push_back(weights[i]);
        lights.push_back(i);
        table.distant_irradiance += static_cast<float>(weights[i]);
    }
    if (lights.empty()) return;
    AliasTable alias = build_alias_table(irradiances);
    const auto light_of = [&](std::uint32_t entry) {
        return lights[std::min<std::size_t>(entry, lights.size() - 1)];
    };
    for (std::uint32_t i = 0; i < alias.entries.size(); ++i) {
        shared::AliasEntry entry = alias.entries[i];
        entry.own = light_of(i);
        entry.other = light_of(entry.other);
        table.distant.push_back(entry);
    }
    for (std::size_t i = 0; i < lights.size(); ++i) table.lights[lights[i]].distant_pmf = alias.pmf[i];
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

LightBounds light_bounds(const EmissiveTriangle& t) {
    LightBounds b;
    b.lower = glm::min(t.p0, glm::min(t.p1, t.p2));
    b.upper = glm::max(t.p0, glm::max(t.p1, t.p2));
    const glm::vec3 normal = glm::cross(t.p1 - t.p0, t.p2 - t.p0);
    const float length = glm::length(normal);
    b.axis = length > 0 ? normal / length : glm::vec3(0, 0, 1);
    b.two_sided = t.two_sided;
    b.intensity = positive(t.area * luminance(t.emission));
    return b;
}

LightBounds light_bounds(const Light& light) {
    LightBounds b;
    if (light.kind == LightKind::directional) return b;
    b.lower = b.upper = light.position;
    b.intensity = positive(luminance(light.intensity));
    b.cos_normals = -1;
    if (light.kind == LightKind::spot) {
        b.axis = light.direction;
        b.cos_normals = 1;
        b.cos_emission = std::cos(light.outer_cone_angle);
    }
    return b;
}

double distant_irradiance(const Light& light) {
    return light.kind == LightKind::directional ? positive(luminance(light.intensity)) : 0;
}

double distant_irradiance(const Environment& environment) {
    return positive(pi * luminance(mean_radiance(environment)));
}

LightTable build_light_table(const Scene& scene, std::span<const EmissiveTriangle> triangles,
                             float scene_radius) {
    LightTable table;
    std::vector<LightBounds> bounds;     // per light; without intensity: not in the tree
    std::vector<double> distant_weights; // per light
    const auto add = [&](const shared::LightRecord& record, double power, const LightBounds& where,
                         double irradiance, std::uint32_t feature) {
        table.lights.push_back(record);
        table.powers.push_back(power);
        bounds.push_back(where);
        distant_weights.push_back(irradiance);
        table.features |= feature;
    };
    for (const EmissiveTriangle& t : triangles)
        add(triangle_record(t), light_power(t), light_bounds(t), 0, shared::FEATURE_EMISSIVE_TRIANGLES);
    for (const Light& light : scene.lights)
        add(punctual_record(light), light_power(light, scene_radius), light_bounds(light),
            distant_irradiance(light), shared::FEATURE_PUNCTUAL_LIGHTS);
    if (scene.environment) {
        shared::LightRecord record{};
        record.kind = shared::LIGHT_ENVIRONMENT;
        record.radiance = scene.environment->scale;
        table.environment_light = static_cast<std::uint32_t>(table.lights.size());
        add(record, light_power(*scene.environment, scene_radius), {}, distant_irradiance(*scene.environment),
            scene.environment->radiance.empty() ? shared::FEATURE_CONSTANT_ENVIRONMENT
                                                : shared::FEATURE_ENVIRONMENT_MAP);
    }
    AliasTable alias = build_alias_table(table.powers);
    for (std::size_t i = 0; i < table.lights.size(); ++i) table.lights[i].power_pmf = alias.pmf[i];
    table.alias = std::move(alias.entries);
    add_distant(distant_weights, table);
    table.tree = build_light_tree(bounds);
    return table;
}

namespace {

// Of each part of BIND_LIGHTS, in texels, and where the last one ends.
struct Layout {
    std::uint32_t alias, distant, tree, trails, end;

    explicit Layout(const LightTable& table) {
        const auto size = [](const auto& part) { return static_cast<std::uint32_t>(part.size()); };
        alias = size(table.lights) * shared::LIGHT_TEXELS;
        distant = alias + size(table.alias);
        // Pairs do not straddle cache lines.
        tree = (distant + size(table.distant) + 3u) / 4u * 4u;
        trails = tree + size(table.tree.nodes) * (shared::LIGHT_TREE_PAIR_TEXELS / 2);
        end = trails + (size(table.tree.trails) + 3u) / 4u;
    }
};

} // namespace

std::vector<glm::uvec4> LightTable::words() const {
    static_assert(sizeof(shared::AliasEntry) == sizeof(glm::uvec4));
    const Layout at(*this);
    std::vector<glm::uvec4> result(at.end);
    const auto put = [&](std::uint32_t first, const auto& part) {
        if (!part.empty()) std::memcpy(result.data() + first, part.data(), part.size() * sizeof(part[0]));
    };
    put(0, lights);
    put(at.alias, alias);
    put(at.distant, distant);
    put(at.tree, tree.nodes);
    put(at.trails, tree.trails);
    return result;
}

void LightTable::describe(shared::FrameRecord& frame) const {
    const Layout at(*this);
    frame.light_count = static_cast<std::uint32_t>(lights.size());
    frame.environment_light = environment_light;
    frame.alias_first = at.alias;
    frame.distant_first = at.distant;
    frame.distant_slots = static_cast<std::uint32_t>(distant.size());
    frame.distant_irradiance = distant_irradiance;
    frame.tree_first = at.tree;
    frame.tree_nodes = static_cast<std::uint32_t>(tree.nodes.size());
    frame.trails_first = at.trails;
}

} // namespace ajar
