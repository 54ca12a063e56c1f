// Applies one function of shaders/core to many items; see core_functions.glsl.h.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "core_functions.glsl.h"
#include "core/color.glsl"
#include "core/filter.glsl"
#include "core/frame.glsl"
#include "core/octahedral.glsl"
#include "core/sampler.glsl"
#include "core/variants.glsl"
#include "core/warps.glsl"
#include "core/workgroup.glsl"

layout(push_constant, scalar) uniform ArgsBlock { CoreFunctionsArgs args; };

vec4 warp(vec2 u) {
    vec3 w = vec3(0.0);
    switch (OPTION) {
    case CORE_DISK: return vec4(warps_disk(u), 0.0, warps_disk_pdf_area());
    case CORE_COSINE_HEMISPHERE:
        w = warps_cosine_hemisphere(u);
        return vec4(w, warps_cosine_hemisphere_pdf(w.z));
    case CORE_SPHERE: return vec4(warps_sphere(u), warps_sphere_pdf());
    case CORE_HEMISPHERE: return vec4(warps_hemisphere(u), warps_hemisphere_pdf());
    case CORE_CONE: return vec4(warps_cone(u, args.parameters.x), warps_cone_pdf(args.parameters.x));
    case CORE_TRIANGLE: return vec4(warps_triangle(u), 0.0, 2.0);
    case CORE_FILTER_BOX: return vec4(filter_sample(FILTER_BOX, args.parameters.x, u), 0.0, 0.0);
    case CORE_FILTER_GAUSSIAN: return vec4(filter_sample(FILTER_GAUSSIAN, args.parameters.x, u), 0.0, 0.0);
    default: return vec4(filter_sample(FILTER_BLACKMAN_HARRIS, args.parameters.x, u), 0.0, 0.0);
    }
}

uvec4 integers(uvec4 x) {
    switch (OPTION) {
    case CORE_SAMPLER: {
        const Sampler s = sampler_begin(x.x, x.y, x.z, args.samples_log2);
        return floatBitsToUint(vec4(sampler_2d(s, x.w), sampler_1d(s, x.w), 0.0));
    }
    case CORE_SOBOL: return uvec4(sampler_sobol1_reversed(x.x));
    case CORE_SCRAMBLE: return uvec4(sampler_scramble(x.x, x.y));
    case CORE_HASH:
        return uvec4(rng_hash(x.x), rng_combine(x.x, x.y), floatBitsToUint(rng_hash_to_float(x.x)),
                     floatBitsToUint(rng_salted_float(x.x, x.y, x.z)));
    default: return floatBitsToUint(vec4(octahedral_decode(x.x), 0.0));
    }
}

vec4 vectors(vec4 v) {
    const vec3 parameter = args.parameters.xyz;
    switch (OPTION) {
    case CORE_SRGB: return vec4(color_srgb_decode(v.xyz), color_luminance(v.xyz));
    case CORE_FRAME: return vec4(frame_make(v.xyz).t, 0.0);
    case CORE_FRAME_B: return vec4(frame_make(v.xyz).b, 0.0);
    case CORE_FRAME_TANGENT: {
        const Frame f = frame_from_tangent(v.xyz, parameter, v.w);
        return vec4(f.t, dot(cross(f.n, f.t), f.b));
    }
    case CORE_FRAME_ROUND_TRIP: {
        const Frame f = frame_make(v.xyz);
        return vec4(frame_to_world(f, frame_to_local(f, parameter)), 0.0);
    }
    case CORE_ERFINV: return vec4(math_erfinv(v.x));
    case CORE_ANGLE: return vec4(math_angle(v.x, v.y));
    case CORE_SINE_COSINE: return vec4(math_sine_cosine(v.x), 0.0, 0.0);
    default: return vec4(math_finite(v.xyz) ? 1.0 : 0.0);
    }
}

void main() {
    const uint i = workgroup_index() * WORKGROUP_SIZE + gl_LocalInvocationID.x;
    if (i >= args.count) return;
    const uvec4 x = args.items_in.at[i].value;
    uvec4 result;
    if (OPTION <= CORE_FILTER_BLACKMAN_HARRIS) {
        result = floatBitsToUint(warp(uintBitsToFloat(x.xy)));
    } else if (OPTION <= CORE_HASH || OPTION == CORE_OCTAHEDRAL) {
        result = integers(x);
    } else {
        result = floatBitsToUint(vectors(uintBitsToFloat(x)));
    }
    args.items_out.at[i].value = result;
}
