// Spot light of KHR_lights_punctual: a point light times the angular profile that it recommends,
// clamp(scale cos + offset, 0, 1)^2, scale = 1 / max(0.001, cos inner - cos outer), offset = -scale cos outer
#ifndef AJAR_LIGHTS_SPOT_GLSL
#define AJAR_LIGHTS_SPOT_GLSL
#include "point.glsl"

float light_spot_profile(LightRecord light, vec3 wi) {
    const float linear = clamp(-dot(light.p1, wi) * light.p2.y + light.p2.z, 0.0, 1.0);
    return linear * linear;
}

LightSample light_spot_sample(LightRecord light, vec3 point) {
    LightSample s = light_point_sample(light, point);
    s.radiance *= light_spot_profile(light, s.wi);
    return s;
}

#endif
