// Adds to the film's fixed-point sums (film.glsl.h) without 64-bit integers. All splits are exact in floats:
// a float's
// 24 bits are cut at word borders by floor and subtraction of powers of two.
#ifndef AJAR_FILM_GLSL
#define AJAR_FILM_GLSL
#include "../shared/film.glsl.h"

// a + b on words, low first; the carry out of the last is dropped by callers that saturate before.
uvec2 film_add64(uvec2 sum, uvec2 value) {
    uint carry;
    uint low = uaddCarry(sum.x, value.x, carry);
    return uvec2(low, sum.y + value.y + carry);
}

// 0 <= x <= FILM_MAX_SAMPLE in units of 2^-28.
uvec2 film_fixed_radiance(float x) {
    float high = floor(x * 0.0625);                 // 2^-4: units of 2^4 = 2^32 quanta
    float low = (x * 0.0625 - high) * 4294967296.0; // below 2^32, exact
    return uvec2(uint(low), uint(high));
}

// 0 <= x <= FILM_MAX_SAMPLE^2 in units of 2^-44.
uvec3 film_fixed_square(float x) {
    float high = floor(x * 9.5367431640625e-7); // 2^-20
    float rest = x - high * 1048576.0;
    float middle = floor(rest * 4096.0);        // 2^12
    float low = (rest - middle * 0.000244140625) * 17592186044416.0; // 2^-12, 2^44
    return uvec3(uint(low), uint(middle), uint(high));
}

// Adds one channel of one sample; saturates instead of wrapping.
void film_add(inout FilmPixel pixel, uint channel, float x) {
    uvec2 sum = uvec2(pixel.sum[2u * channel], pixel.sum[2u * channel + 1u]);
    uvec2 added = film_add64(sum, film_fixed_radiance(x));
    if (added.y < sum.y) added = uvec2(0xffffffffu);
    pixel.sum[2u * channel] = added.x;
    pixel.sum[2u * channel + 1u] = added.y;

    uvec3 square = film_fixed_square(x * x);
    uint carry_low;
    uint carry_middle;
    uint carry_extra;
    uint low = uaddCarry(pixel.square[3u * channel], square.x, carry_low);
    uint middle = uaddCarry(pixel.square[3u * channel + 1u], square.y, carry_middle);
    middle = uaddCarry(middle, carry_low, carry_extra);
    uint high = pixel.square[3u * channel + 2u] + square.z + carry_middle + carry_extra;
    bool full = high < pixel.square[3u * channel + 2u];
    pixel.square[3u * channel] = full ? 0xffffffffu : low;
    pixel.square[3u * channel + 1u] = full ? 0xffffffffu : middle;
    pixel.square[3u * channel + 2u] = full ? 0xffffffffu : high;
}

// A signed value in units of 2^-32, two's complement, cut at +-2^30.
uvec2 film_fixed_signed(float x) {
    float a = min(abs(x), 1073741824.0);
    float high = floor(a);
    uvec2 value = uvec2(uint((a - high) * 4294967296.0), uint(high));
    if (x < 0.0) {
        uint carry;
        uint low = uaddCarry(~value.x, 1u, carry);
        value = uvec2(low, ~value.y + carry);
    }
    return value;
}

#endif
