// Colours: linear Rec. 709, and sRGB's transfer function (IEC 61966-2-1).
#ifndef AJAR_COLOR_GLSL
#define AJAR_COLOR_GLSL
#extension GL_GOOGLE_include_directive : require

float color_luminance(vec3 rgb) { return dot(rgb, vec3(0.2126, 0.7152, 0.0722)); }

// sRGB in [0, 1] to linear. y^2.4 = y (y^0.5)^2.8, and the last factor is close to a polynomial: least
// maximum error, 2.5e-7 absolute and 8e-5 relative. pow() takes three times as long on lavapipe.
vec3 color_srgb_decode(vec3 c) {
    const vec3 y = (c + 0.055) * (1.0 / 1.055);
    const vec3 s = sqrt(y);
    vec3 p = vec3(0.02041193);
    p = p * s - 0.12475294;
    p = p * s + 0.97079221;
    p = p * s + 0.15260926;
    p = p * s - 0.02061247;
    p = p * s + 0.00155225;
    return mix(p * y, c * (1.0 / 12.92), lessThanEqual(c, vec3(0.04045)));
}

#endif
