// Applies one function of shaders/bsdf to many items; see bsdf_functions.glsl.h.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "bsdf_functions.glsl.h"
#include "bsdf/bsdf.glsl"
#include "bsdf/shading_normal.glsl"
#include "core/workgroup.glsl"

layout(push_constant, scalar) uniform ArgsBlock { BsdfFunctionsArgs args; };

Bsdf make() {
    MaterialPoint m;
    m.base_color = vec4(args.base_color, 1.0);
    m.emission = vec3(0.0);
    m.metallic = args.metallic;
    m.alpha_ggx = args.alpha;
    m.normal_ts = vec3(0.0, 0.0, 1.0);
    m.f0_dielectric = args.f0;
    m.f90_dielectric = args.f90;
    m.flags = 0u;
    return bsdf_make(m);
}

vec3 polar(float theta, float phi) { return vec3(sin(theta) * cos(phi), sin(theta) * sin(phi), cos(theta)); }

// f cos and pdf at one point of a cell, times the solid angle per unit of (s, t).
vec2 integrand(Bsdf b, vec2 st) {
    const float phi = 2.0 * MATH_PI * st.y;
    vec3 wi;
    float jacobian;
    if (OPTION == BSDF_INTEGRATE_DIRECTION) {
        const float theta = 0.5 * MATH_PI * st.x;
        wi = polar(theta, phi);
        jacobian = MATH_PI * MATH_PI * sin(theta);
    } else {
        const float width = max(args.alpha, DELTA_ALPHA);
        const float rate = log(1.0 + 0.5 * MATH_PI / width);
        const float theta = width * (exp(rate * st.x) - 1.0);
        const vec3 h = polar(theta, phi);
        wi = 2.0 * dot(args.wo, h) * h - args.wo;
        // Solid angle of wi: 4 (wo.h) that of h.
        jacobian = 2.0 * MATH_PI * sin(theta) * rate * (theta + width) * 4.0 * max(dot(args.wo, h), 0.0);
    }
    const BsdfValue value = bsdf_eval_pdf(b, args.wo, wi);
    return jacobian * vec2(value.f.r * wi.z, value.pdf);
}

vec4 integrate(Bsdf b, vec4 cell) {
    const vec2 size = cell.yw - cell.xz;
    vec2 sum = vec2(0.0);
    for (uint i = 0u; i < BSDF_INTEGRATE_POINTS; ++i) {
        const uint turned = (i * BSDF_INTEGRATE_GENERATOR) % BSDF_INTEGRATE_POINTS;
        sum += integrand(b, cell.xz + (vec2(i, turned) + 0.5) / float(BSDF_INTEGRATE_POINTS) * size);
    }
    return vec4(sum * (size.x * size.y / float(BSDF_INTEGRATE_POINTS)), 0.0, 0.0);
}

void main() {
    const uint i = workgroup_index() * WORKGROUP_SIZE + gl_LocalInvocationID.x;
    if (i >= args.count) return;
    const Bsdf b = make();
    vec4 result = vec4(0.0);
    switch (OPTION) {
    case BSDF_SAMPLE: {
        const vec4 u = uintBitsToFloat(args.items_in.at[i].value);
        const BsdfSample s = bsdf_sample(b, args.wo, u.xy, u.z);
        args.items_out.at[2 * i].value = floatBitsToUint(vec4(s.wi, s.pdf));
        args.items_out.at[2 * i + 1].value = floatBitsToUint(vec4(s.weight, s.delta ? 1.0 : 0.0));
        return;
    }
    case BSDF_EVAL: {
        const vec3 wo = uintBitsToFloat(args.items_in.at[2 * i].value.xyz);
        const BsdfValue value = bsdf_eval_pdf(b, wo, uintBitsToFloat(args.items_in.at[2 * i + 1].value.xyz));
        result = vec4(value.f, value.pdf);
        break;
    }
    case BSDF_SHADING_NORMAL: {
        const vec3 n = uintBitsToFloat(args.items_in.at[2 * i].value.xyz);
        const vec3 wo = uintBitsToFloat(args.items_in.at[2 * i + 1].value.xyz);
        result = vec4(shading_normal_adapt(n, vec3(0.0, 0.0, 1.0), wo), 0.0);
        break;
    }
    case BSDF_ALBEDO: result = vec4(bsdf_albedo(b), 0.0); break;
    default: result = integrate(b, uintBitsToFloat(args.items_in.at[i].value)); break;
    }
    args.items_out.at[i].value = floatBitsToUint(result);
}
