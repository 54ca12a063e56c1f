// What sampling a light gives, whatever its kind, and what the kinds need in common.
#ifndef AJAR_LIGHT_SAMPLE_GLSL
#define AJAR_LIGHT_SAMPLE_GLSL
#include "../core/tables.glsl"
#include "../shared/light.glsl.h"
#include "../shared/path.glsl.h"

// A direction towards a light as seen from a point. pdf == 0: there is none from here (radiance is 0 too).
struct LightSample {
    vec3 wi;        // world, unit, towards the light
    float distance; // metres; LIGHT_FAR for directional lights and the environment
    float reach;    // metres: what can be in the way is nearer; it is not the light itself
    vec3 radiance;  // arriving along wi if unoccluded; delta lights: irradiance at normal incidence, W/m^2
    float pdf;      // of wi by solid angle (1/sr), given the light; 1 for delta lights
    bool delta;     // no other sampling can find this light: no MIS
    uint triangle;  // the emitting one, or NO_TRIANGLE
};

const float LIGHT_FAR = 3.402823e38; // the largest float: all geometry is nearer

// Squared metres. Nearer than this a squared distance is made of subnormal parts, and 1 / d^2 runs out of
// range: no sample.
const float LIGHT_NEAR_SQUARED = 1e-30;

LightSample light_sample_none() {
    return LightSample(vec3(0.0, 0.0, 1.0), 0.0, 0.0, vec3(0.0), 0.0, false, NO_TRIANGLE);
}

LightRecord light_fetch(uint light) {
    const uint first = light * LIGHT_TEXELS;
    const uvec4 a = fetch_light(first);
    const uvec4 b = fetch_light(first + 1u);
    const uvec4 c = fetch_light(first + 2u);
    const uvec4 d = fetch_light(first + 3u);
    return LightRecord(uintBitsToFloat(a.xyz), a.w, uintBitsToFloat(b.xyz), b.w, uintBitsToFloat(c.xyz),
                       uintBitsToFloat(c.w), uintBitsToFloat(d.xyz), uintBitsToFloat(d.w));
}

#endif
