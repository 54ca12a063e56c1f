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

// Not NaN, not Inf. The sum of absolute values is NaN or Inf as soon as one component is; comparing the
// number instead of calling isnan() survives drivers that assume there are no NaNs.
bool math_finite(vec3 v) { return abs(v.x) + abs(v.y) + abs(v.z) <= 3.402823e38; }

// The inverse error function: Giles 2010, "Approximating the erfinv function", table 5 (single precision;
// relative error below 4e-7 where |x| < 1 - 1e-7). Both branches are polynomials in one variable, so they are
// selected, not branched to.
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
