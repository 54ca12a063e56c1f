// Point light of KHR_lights_punctual: intensity (W/sr) over d^2, cut off towards its range as it says there.
#ifndef AJAR_LIGHTS_POINT_GLSL
#define AJAR_LIGHTS_POINT_GLSL
#include "light_sample.glsl"

// The extension's range attenuation without its 1 / d^2: max(min(1 - (d / range)^4, 1), 0). 1 without one.
float light_range_window(float distance2, float inverse_range2) {
    const float ratio2 = distance2 * inverse_range2;
    return max(1.0 - ratio2 * ratio2, 0.0);
}

LightSample light_point_sample(LightRecord light, vec3 point) {
    const vec3 to_light = light.p0 - point;
    const float distance2 = dot(to_light, to_light);
    const bool valid = distance2 > LIGHT_NEAR_SQUARED && distance2 <= LIGHT_FAR;
    LightSample s = light_sample_none();
    s.distance = sqrt(distance2);
    s.wi = valid ? to_light / s.distance : s.wi;
    s.radiance = valid ? light.radiance * (light_range_window(distance2, light.p2.x) / distance2) : vec3(0.0);
    s.pdf = valid ? 1.0 : 0.0;
    s.delta = true;
    return s;
}

#endif
