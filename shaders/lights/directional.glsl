// Directional light of KHR_lights_punctual: parallel light from infinitely far, irradiance in W/m^2.
#ifndef AJAR_LIGHTS_DIRECTIONAL_GLSL
#define AJAR_LIGHTS_DIRECTIONAL_GLSL
#include "light_sample.glsl"

LightSample light_directional_sample(LightRecord light) {
    LightSample s = light_sample_none();
    s.wi = -light.p1;
    s.distance = LIGHT_FAR;
    s.radiance = light.radiance;
    s.pdf = 1.0;
    s.delta = true;
    return s;
}

#endif
