// Pixel filters by importance sampling: the place of a sample is distributed as the filter, so every sample
// weighs 1 (Ernst et al. 2006, "Filter Importance Sampling"). Separable and symmetric.
#ifndef AJAR_FILTER_GLSL
#define AJAR_FILTER_GLSL
#include "../shared/frame.glsl.h"
#include "math.glsl"

// Quantile of a bell on [-1, 1] in terms of g = erfinv(2u - 1), in which both bells are nearly straight.
// Blackman-Harris (4 terms; Harris 1978): its integral has no inverse in closed form. The polynomial's error
// is below 3e-5 of the filter's mass everywhere.
float filter_blackman_harris(float g) {
    const float g2 = g * g;
    float p = 9.930602759694596e-7;
    p = p * g2 - 1.604829032183586e-5;
    p = p * g2 - 6.228531765781534e-5;
    p = p * g2 - 8.521188309991904e-3;
    p = p * g2 + 0.4047572724412365;
    return clamp(p * g, -1.0, 1.0);
}

// Offset from the pixel's centre, in pixels, within [-radius, radius]. FILTER_GAUSSIAN: standard deviation
// radius / 3, cut off at the radius.
vec2 filter_sample(uint kind, float radius, vec2 u) {
    const vec2 t = 2.0 * u - 1.0;
    if (kind == FILTER_BOX) return radius * t;
    // erf(3 / sqrt(2)): the part of the bell within three standard deviations.
    const vec2 s = t * (kind == FILTER_GAUSSIAN ? 0.99730020393674 : 1.0);
    const vec2 g = vec2(math_erfinv(s.x), math_erfinv(s.y));
    if (kind == FILTER_GAUSSIAN) return radius * 0.4714045207910317 * g; // sqrt(2) / 3
    return radius * vec2(filter_blackman_harris(g.x), filter_blackman_harris(g.y));
}

#endif
