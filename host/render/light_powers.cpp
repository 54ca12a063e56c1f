// What lights send out, and how far: powers, bounds, irradiances.
#include "render/environment_table.hpp"
#include "render/light_records.hpp"
#include "render/luminance.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ajar {

namespace {

using std::numbers::pi;

double positive(double x) { return std::isfinite(x) && x > 0 ? x : 0; }

// A scene without extent still gets its light.
double disk_area(float scene_radius) {
    return pi * (scene_radius > 0 ? double{scene_radius} * scene_radius : 1.0);
}

} // namespace

double light_power(const EmissiveSphere& s) {
    return positive(4 * pi * pi * double{s.radius} * s.radius * luminance(s.emission));
}

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

LightBounds light_bounds(const EmissiveSphere& s) {
    LightBounds b;
    b.lower = s.center - s.radius;
    b.upper = s.center + s.radius;
    b.cos_normals = -1;
    b.intensity = positive(pi * s.radius * s.radius * luminance(s.emission));
    return b;
}

LightBounds light_bounds(const Light& light) {
    LightBounds b;
    if (light.kind == LightKind::directional) return b;
    b.lower = light.position - light.radius;
    b.upper = light.position + light.radius;
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

} // namespace ajar
