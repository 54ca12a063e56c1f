// Shading normals that a mirror can live with. Interpolated and mapped normals can turn so far from wo that
// wo lies below their horizon, or that the mirror direction enters the surface: black spots. The normal is
// bent towards the geometric one, in their plane, just until the mirror direction leaves the surface (as
// Cycles does; solved here by double angles).
#ifndef AJAR_SHADING_NORMAL_GLSL
#define AJAR_SHADING_NORMAL_GLSL
#include "../core/math.glsl"

// n, ng: unit, ng and wo on one side of the surface. Returns n where it is good enough; always dot(result,
// wo) > 0.
vec3 shading_normal_adapt(vec3 n, vec3 ng, vec3 wo) {
    // Angles from ng in the plane of ng and n: n at theta, wo's part r in the plane at phi. Then the mirror
    // direction's height is r cos(2 theta - phi). It shall be at least `height`, which ng itself reaches
    // (theta = 0).
    const float n_z = dot(n, ng);
    const vec3 across = n - n_z * ng;
    const float n_x = length(across);
    const vec3 x_axis = across / max(n_x, 1e-20);
    const float wo_x = dot(wo, x_axis);
    const float wo_z = dot(wo, ng);
    // 0.6 degrees above the surface (Cycles' threshold), or nearly wo's own height when that is lower.
    const float height = min(0.9 * wo_z, 0.01);
    const float mirror_z = 2.0 * (n_x * wo_x + n_z * wo_z) * n_z - wo_z;
    // Above with n on the wrong side of wo or of ng, the mirror direction is of no use.
    const bool good = mirror_z >= height && n_z > 0.0 && n_x * wo_x + n_z * wo_z > 0.0;
    const float r = sqrt(max(wo_x * wo_x + wo_z * wo_z, 1e-20));
    const float cos_arc = height / r;
    const float sin_arc = math_safe_sqrt(1.0 - cos_arc * cos_arc);
    const float cos_2theta = (wo_z * cos_arc - wo_x * sin_arc) / r;
    const float sin_2theta = max((wo_z * sin_arc + wo_x * cos_arc) / r, 1e-10); // 0 only where wo_z is
    // Halved by bisecting: arccosines and half-angle formulas lose digits at one end or the other.
    const vec3 bent = normalize(ng * (1.0 + cos_2theta) + x_axis * sin_2theta);
    return good || n_x < 1e-6 ? (n_z > 0.0 ? n : ng) : bent;
}

#endif
