#include "render/light_records.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ajar {

namespace {

using std::numbers::pi;

// Below this a disk is not told from a point by directions in floats, nor a half angle by its cosine.
constexpr float LEAST_DIAMETER = 2e-6f; // radians

} // namespace

glm::vec2 spot_scale_offset(const Light& light) {
    const float outer = std::cos(light.outer_cone_angle);
    const float scale = 1.0f / std::max(0.001f, std::cos(light.inner_cone_angle) - outer);
    return {scale, -outer * scale};
}

bool is_soft(const Light& light) {
    if (light.kind == LightKind::directional) return light.angular_diameter > LEAST_DIAMETER;
    return light.radius > 0 && std::isfinite(1 / (light.radius * light.radius));
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

namespace {

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

shared::LightRecord sun_record(const Light& light) {
    const double half = std::sin(0.25 * light.angular_diameter);
    const double cap = 2 * half * half; // 1 - cos(diameter / 2)
    shared::LightRecord record{};
    record.kind = shared::LIGHT_SUN | shared::LIGHT_LAMP;
    record.p0 = -light.direction;
    record.extent = static_cast<float>(cap);
    record.radiance = light.intensity / static_cast<float>(pi * cap * (2 - cap));
    return record;
}

// Profile and range as a spot's; a point light's profile is the constant 1.
shared::LightRecord lamp_record(const Light& light) {
    shared::LightRecord record = punctual_record(light);
    record.kind = shared::LIGHT_SPHERE | shared::LIGHT_LAMP;
    record.extent = light.radius;
    record.radiance = light.intensity / (std::numbers::pi_v<float> * light.radius * light.radius);
    if (light.kind == LightKind::point) record.p2.z = 1;
    return record;
}

} // namespace

shared::LightRecord light_record(const Light& light) {
    if (!is_soft(light)) return punctual_record(light);
    return light.kind == LightKind::directional ? sun_record(light) : lamp_record(light);
}

// Larger by the rounding of its vertices' world coordinates (and of distances to them), so that all its
// triangles lie inside.
shared::LightRecord sphere_record(const EmissiveSphere& sphere) {
    const glm::vec3 size = glm::abs(sphere.center) + sphere.radius;
    shared::LightRecord record{};
    record.kind = shared::LIGHT_SPHERE;
    record.p0 = sphere.center;
    record.p2.z = 1;
    record.extent = sphere.radius + 0x1p-18f * std::max({size.x, size.y, size.z});
    record.radiance = sphere.emission;
    return record;
}

} // namespace ajar
