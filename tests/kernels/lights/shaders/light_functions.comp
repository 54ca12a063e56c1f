// Applies one function of shaders/lights to many items; see light_functions.glsl.h.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "light_functions.glsl.h"
#include "core/workgroup.glsl"
#include "lights/light.glsl"
#include "lights/light_sampler.glsl"
#include "lights/soft.glsl"

layout(push_constant, scalar) uniform ArgsBlock { LightFunctionsArgs args; };

void sample_light(inout LightItem item) {
    const LightSample s = light_sample(item.light, item.point, item.uv);
    item.direction = s.wi;
    item.distance = s.distance;
    item.radiance = s.radiance;
    item.pdf = s.pdf;
    item.delta = uint(s.delta);
    item.triangle = s.triangle;
}

LightReceiver receiver(LightItem item) {
    return receiver_unpack(item.point, uvec2(octahedral_encode(item.direction), item.triangle));
}

void pick_light(inout LightItem item) {
    const LightPick pick = light_sampler_pick(receiver(item), item.uv.x);
    item.light = pick.light;
    item.pdf = pick.pmf;
    item.uv = vec2(pick.u, light_pick_rest(pick, item.uv.y));
}

void meet_soft(inout LightItem item) {
    uvec2 found = soft_meet(item.point, item.direction, item.distance, item.delta != 0u);
    item.triangle = 0u;
    item.light = NO_LIGHT;
    item.pdf = 0.0;
    while (any(notEqual(found, uvec2(0u)))) {
        const uint light = soft_next(found);
        const vec4 radiance_pdf = soft_lookup(light, item.point);
        const bool first = item.triangle == 0u;
        item.light = first ? light : item.light;
        item.radiance = first ? radiance_pdf.rgb : item.radiance;
        item.pdf = first ? radiance_pdf.a : item.pdf;
        ++item.triangle;
    }
}

void main() {
    const uint i = workgroup_index() * WORKGROUP_SIZE + gl_LocalInvocationID.x;
    if (i >= args.count) return;
    LightItem item = args.items.at[i];
    switch (OPTION) {
    case LIGHTS_SAMPLE: sample_light(item); break;
    case LIGHTS_PICK: pick_light(item); break;
    case LIGHTS_PMF: item.pdf = light_sampler_pmf(receiver(item), item.light); break;
    case LIGHTS_SOFT: meet_soft(item); break;
    case LIGHTS_ENVIRONMENT: {
        const vec4 found = environment_lookup(item.direction);
        item.radiance = found.rgb;
        item.pdf = found.a;
        break;
    }
    default: item.pdf = light_pdf_triangle(item.point, item.direction, item.triangle); break;
    }
    args.items.at[i] = item;
}
