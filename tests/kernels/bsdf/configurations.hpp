// The table that BSDF tests loop over: add a row, and the material is chi-square-, furnace- and
// agreement-tested. Beside it, appendix B of glTF 2.0 written down in double as the reference.
#pragma once

#include <glm/glm.hpp>
#include <span>

namespace ajar::test {

struct Configuration {
    const char* name;
    glm::vec3 base_color;
    float metallic;
    glm::vec3 f0; // of the dielectric
    float f90;
};

inline constexpr Configuration LAMBERT{"Lambert", {0.8f, 0.5f, 0.2f}, 0, {0, 0, 0}, 0};
inline constexpr Configuration WHITE_LAMBERT{"white Lambert", {1, 1, 1}, 0, {0, 0, 0}, 0};
inline constexpr Configuration WHITE_METAL{
    "white metal", {1, 1, 1}, 1, {0, 0, 0}, 0}; // F = 1: the lobe alone

inline constexpr Configuration CONFIGURATIONS[] = {
    LAMBERT,
    WHITE_METAL,
    {"gold", {1.0f, 0.77f, 0.34f}, 1, {0.04f, 0.04f, 0.04f}, 1},
    {"plastic", {0.8f, 0.3f, 0.1f}, 0, {0.04f, 0.04f, 0.04f}, 1},
    {"black gloss", {0, 0, 0}, 0, {0.04f, 0.04f, 0.04f}, 1},
    {"half metal, tinted, half specular", {0.2f, 0.6f, 0.9f}, 0.5f, {0.02f, 0.01f, 0.04f}, 0.5f},
};

inline constexpr float ROUGHNESSES[] = {0.04f, 0.1f, 0.3f, 0.5f, 0.75f, 1.0f};
inline constexpr float ANGLES_DEGREES[] = {0, 35, 65, 80, 88.5f};

// f in 1/sr for both cosines positive: appendix B with KHR_materials_specular, term by term (F_Schlick,
// D_GGX, V_GGX).
glm::dvec3 reference_bsdf(const Configuration& c, double alpha, const glm::dvec3& wo, const glm::dvec3& wi);

// D and G1 of GGX (Heitz 2014, equations 71 and 72).
double reference_ggx(double alpha, double cos_h);
double reference_masking(double alpha, double cos_o);

} // namespace ajar::test
