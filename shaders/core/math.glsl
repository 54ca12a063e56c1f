// Constants and small functions that GLSL lacks.
#ifndef AJAR_MATH_GLSL
#define AJAR_MATH_GLSL
#extension GL_GOOGLE_include_directive : require

const float MATH_PI = 3.14159265358979f;
const float MATH_INV_PI = 0.318309886183791f;

float math_sqr(float x) { return x * x; }
float math_safe_sqrt(float x) { return sqrt(max(x, 0.0)); }
float math_max3(vec3 v) { return max(v.x, max(v.y, v.z)); }

float math_pow5(float x) {
    const float x2 = x * x;
    return x2 * x2 * x;
}

// The angle, [0, pi], of the point (x, y) with y >= 0; 0 for (0, 0). atan() of two numbers without its
// other half plane, and to 1e-7 where lavapipe's is off by 2e-5. Polynomial: Abramowitz and Stegun 1964,
// 4.4.49.
float math_angle(float y, float x) {
    const float size = abs(x);
    const float lesser = y < size ? y : size;
    const float greater = y < size ? size : y;
    const float t = lesser / greater;
    const float t2 = t * t;
    float a = 0.0028662257;
    a = -0.0161657367 + a * t2;
    a = 0.0429096138 + a * t2;
    a = -0.0752896400 + a * t2;
    a = 0.1065626393 + a * t2;
    a = -0.1420889944 + a * t2;
    a = 0.1999355085 + a * t2;
    a = -0.3333314528 + a * t2;
    a = t + t * t2 * a;
    a = y < size ? a : 0.5 * MATH_PI - a;
    a = x < 0.0 ? MATH_PI - a : a;
    return greater > 0.0 ? a : 0.0;
}

// Sine and cosine of x in [0, pi], the sine precise in proportion to itself, where a GPU's own is good to
// 2^-21 of 1. Polynomials: Abramowitz and Stegun 1964, 4.3.97 and 4.3.99.
vec2 math_sine_cosine(float x) {
    const float m = x < 0.5 * MATH_PI ? x : MATH_PI - x;
    const float m2 = m * m;
    float s = 0.0000027526 - 0.0000000239 * m2;
    s = -0.0001984090 + s * m2;
    s = 0.0083333315 + s * m2;
    s = -0.1666666664 + s * m2;
    float c = 0.0000247609 - 0.0000002605 * m2;
    c = -0.0013888397 + c * m2;
    c = 0.0416666418 + c * m2;
    c = -0.4999999963 + c * m2;
    c = 1.0 + m2 * c;
    return vec2(m + m * m2 * s, x < 0.5 * MATH_PI ? c : -c);
}

// Not NaN, not Inf. The sum of absolute values is NaN or Inf as soon as one component is; comparing the
// number instead of calling isnan() survives drivers that assume there are no NaNs.
bool math_finite(vec3 v) { return abs(v.x) + abs(v.y) + abs(v.z) <= 3.402823e38; }

// The inverse error function: Giles 2010, "Approximating the erfinv function", table 5 (single precision;
// relative error below 4e-7 where |x| < 1 - 1e-7). Both branches are polynomials in one variable, so they
// are selected, not branched to.
float math_erfinv(float x) {
    const float w = -log(max((1.0 - x) * (1.0 + x), 1e-30));
    const float a = w - 2.5;
    float central = 2.81022636e-08;
    central = 3.43273939e-07 + central * a;
    central = -3.5233877e-06 + central * a;
    central = -4.39150654e-06 + central * a;
    central = 0.00021858087 + central * a;
    central = -0.00125372503 + central * a;
    central = -0.00417768164 + central * a;
    central = 0.246640727 + central * a;
    central = 1.50140941 + central * a;
    const float b = sqrt(w) - 3.0;
    float tail = -0.000200214257;
    tail = 0.000100950558 + tail * b;
    tail = 0.00134934322 + tail * b;
    tail = -0.00367342844 + tail * b;
    tail = 0.00573950773 + tail * b;
    tail = -0.0076224613 + tail * b;
    tail = 0.00943887047 + tail * b;
    tail = 1.00167406 + tail * b;
    tail = 2.83297682 + tail * b;
    return x * (w < 5.0 ? central : tail);
}

#endif
