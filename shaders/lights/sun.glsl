// Sun: a directional light with an angular diameter, of uniform radiance within its cone, and of the
// irradiance at normal incidence that the light states: radiance = irradiance / (pi sin^2(half angle)).
#ifndef AJAR_LIGHTS_SUN_GLSL
#define AJAR_LIGHTS_SUN_GLSL
#include "../core/frame.glsl"
#include "../core/warps.glsl"
#include "light_sample.glsl"

LightSample light_sun_sample(LightRecord light, vec2 u) {
    LightSample s = light_sample_none();
    s.wi = frame_to_world(frame_make(light.p0), warps_cone(u, light.extent));
    s.distance = LIGHT_FAR;
    s.radiance = light.radiance;
    s.pdf = warps_cone_pdf(light.extent);
    s.delta = (light.kind & LIGHT_UNMET) != 0u;
    return s;
}

#endif
