#include "configurations.hpp"

#include <algorithm>
#include <cmath>

namespace ajar::test {

namespace {
constexpr double PI = 3.14159265358979323846;
}

double reference_ggx(double alpha, double cos_h) {
    if (cos_h <= 0) return 0;
    const double tan2 = 1 / (cos_h * cos_h) - 1;
    const double bracket = 1 + tan2 / (alpha * alpha);
    return 1 / (PI * alpha * alpha * std::pow(cos_h, 4) * bracket * bracket);
}

double reference_masking(double alpha, double cos_o) {
    const double tan2 = 1 / (cos_o * cos_o) - 1;
    const double lambda = (-1 + std::sqrt(1 + alpha * alpha * tan2)) / 2;
    return 1 / (1 + lambda);
}

glm::dvec3 reference_bsdf(const Configuration& c, double alpha, const glm::dvec3& wo, const glm::dvec3& wi) {
    const glm::dvec3 h = glm::normalize(wo + wi);
    const double v_dot_h = glm::dot(wo, h);
    const double a2 = alpha * alpha;
    const double n_dot_h = h.z;
    const double n_dot_l = wi.z;
    const double n_dot_v = wo.z;
    // From h's own components: 1 - cos^2 has too few digits even in double for the narrowest lobes.
    const double sin2 = h.x * h.x + h.y * h.y;
    const double d = a2 / (PI * std::pow(sin2 + n_dot_h * n_dot_h * a2, 2));
    const double v = 0.5 / (n_dot_l * std::sqrt(n_dot_v * n_dot_v * (1 - a2) + a2) +
                            n_dot_v * std::sqrt(n_dot_l * n_dot_l * (1 - a2) + a2));
    const auto schlick = [&](const glm::dvec3& f0, double f90) {
        return f0 + (f90 - f0) * std::pow(1 - std::abs(v_dot_h), 5);
    };
    const glm::dvec3 base(c.base_color);
    const glm::dvec3 dielectric_fresnel = schlick(glm::dvec3(c.f0), c.f90);
    const double most = std::max({dielectric_fresnel.x, dielectric_fresnel.y, dielectric_fresnel.z});
    const glm::dvec3 dielectric = (1 - most) * base / PI + dielectric_fresnel * (v * d);
    const glm::dvec3 metal = schlick(base, 1) * (v * d);
    return glm::mix(dielectric, metal, static_cast<double>(c.metallic));
}

} // namespace ajar::test
