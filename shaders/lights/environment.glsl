// Light from all around: an equirectangular map, importance-sampled by inversion of its marginal and
// conditional distributions, or a constant. The lookup is bilinear; the density is constant over each cell's
// solid angle (a cell is a texel, or some of a large map), in proportion to the bilinear radiance averaged
// over it, or to what that has above its mean (environment_table.hpp; Pharr et al. 2023, section 12.5).
#ifndef AJAR_LIGHTS_ENVIRONMENT_GLSL
#define AJAR_LIGHTS_ENVIRONMENT_GLSL
#include "../core/warps.glsl"
#include "light_sample.glsl"

// Between world and map: the map is turned by frame.environment_cos/sin about +Y.
vec3 environment_to_map(vec3 d) {
    const float c = frame.environment_cos;
    const float s = frame.environment_sin;
    return vec3(c * d.x - s * d.z, d.y, s * d.x + c * d.z);
}
vec3 environment_to_world(vec3 d) {
    const float c = frame.environment_cos;
    const float s = frame.environment_sin;
    return vec3(c * d.x + s * d.z, d.y, c * d.z - s * d.x);
}

// Bilinear radiance (rgb, unscaled) at `at`, in texels from the top left corner; wraps around in x, ends at
// the poles. a: the density (1/sr) of the texel that `at` lies in, which is one of the four.
vec4 environment_filter(vec2 at) {
    const uint width = frame.environment_width;
    const uint height = frame.environment_height;
    const vec2 corner = floor(at - 0.5);
    const vec2 w = at - 0.5 - corner;
    const int x = int(corner.x);
    const uint x0 = uint(x < 0 ? x + int(width) : x);
    const uint x1 = uint(x + 1) == width ? 0u : uint(x + 1);
    const uint y0 = uint(clamp(int(corner.y), 0, int(height) - 1));
    const uint y1 = uint(clamp(int(corner.y) + 1, 0, int(height) - 1));
    const vec4 a = uintBitsToFloat(fetch_environment(y0 * width + x0));
    const vec4 b = uintBitsToFloat(fetch_environment(y0 * width + x1));
    const vec4 c = uintBitsToFloat(fetch_environment(y1 * width + x0));
    const vec4 d = uintBitsToFloat(fetch_environment(y1 * width + x1));
    const float upper = w.x < 0.5 ? a.w : b.w;
    const float lower = w.x < 0.5 ? c.w : d.w;
    return vec4(mix(mix(a.rgb, b.rgb, w.x), mix(c.rgb, d.rgb, w.x), w.y), w.y < 0.5 ? upper : lower);
}

// Radiance (rgb, W/(m^2 sr)) from a unit direction of the world, and the density (a, 1/sr) with which
// light_environment_sample finds it.
vec4 environment_lookup(vec3 direction) {
    if (!has_feature(FEATURE_ENVIRONMENT_MAP)) return vec4(frame.background, warps_sphere_pdf());
    vec3 d = environment_to_map(direction);
    const float horizontal = sqrt(d.x * d.x + d.z * d.z);
    d.x = horizontal > 0.0 ? d.x : 1.0; // atan(0, 0) is undefined
    // Not acos(d.y), which loses half the digits at the poles.
    const vec2 uv = vec2(atan(d.z, d.x) * (0.5 * MATH_INV_PI) + 0.5, atan(horizontal, d.y) * MATH_INV_PI);
    const vec2 size = vec2(frame.environment_width, frame.environment_height);
    const vec4 texel = environment_filter(clamp(uv, 0.0, 1.0) * size);
    return vec4(texel.rgb * frame.environment_scale, texel.a);
}
vec3 environment_radiance(vec3 direction) { return environment_lookup(direction).rgb; }
float light_pdf_environment(vec3 direction) { return environment_lookup(direction).a; }

struct EnvironmentStep {
    uint index;     // whose interval of the cumulative distribution holds u
    float fraction; // of that interval below u, [0, 1)
};

// Inverts one of `rows` distributions over `count` entries. They are 8-ary trees from word `first` on, level
// by level, all rows' nodes of a level together; a node is eight 16-bit numbers: where its children begin, in
// units of 2^-16 (environment_table.hpp). `first` moves on to what follows the trees. All lanes take the same
// steps.
EnvironmentStep environment_invert(inout uint first, uint rows, uint row, uint count, float u) {
    const float scaled = u * 65536.0;
    const int target = min(int(scaled), 65534); // the last two units are one entry's
    uint index = 0u;
    uint ahead = uint(65535 - target); // from the target's end to the next entry's begin
    uint last_begun = 0u;
    const uint levels = uint(findMSB(max(count, 2u) - 1u) / 3) + 1u; // 8^levels >= count
    for (uint level = levels; level > 0u; --level) {
        const uint nodes = ((count - 1u) >> (3u * level)) + 1u;
        const uvec4 begins = fetch_environment(first + row * nodes + index);
        // Negative, so huge as unsigned, for children that begin at the target or before.
        const uvec4 even = (begins & 0xffffu) - uint(target + 1);
        const uvec4 odd = (begins >> 16) - uint(target + 1);
        const uvec4 near = min(even, odd);
        const uvec4 far = max(even, odd);
        ahead = min(ahead, min(min(near.x, near.y), min(near.z, near.w)));
        last_begun = max(max(far.x, far.y), max(far.z, far.w));
        const ivec4 begun = (ivec4(even) >> 31) + (ivec4(odd) >> 31); // -1 each
        index = 8u * index - 1u - uint(begun.x + begun.y + begun.z + begun.w);
        first += rows * nodes;
    }
    const int begin = target + 1 + int(last_begun);
    const int next = target + 1 + int(ahead);
    const int mass = (next == 65535 ? 65536 : next) - begin; // 65535 stands for the end
    return EnvironmentStep(index, (scaled - float(begin)) / float(mass));
}

// The distribution is over cells of 2^k x 2^k texels, at most 2^ENVIRONMENT_CELL_BITS across.
uint environment_cell_shift() {
    const int bits = findMSB(max(max(frame.environment_width, frame.environment_height), 2u) - 1u) + 1;
    return uint(max(bits - ENVIRONMENT_CELL_BITS, 0));
}

LightSample light_environment_map_sample(vec2 u) {
    const uint width = frame.environment_width;
    const uint height = frame.environment_height;
    const uint shift = environment_cell_shift();
    const uint columns = ((width - 1u) >> shift) + 1u;
    const uint rows = ((height - 1u) >> shift) + 1u;
    uint first = width * height;
    const EnvironmentStep y = environment_invert(first, 1u, 0u, rows, u.y);
    const EnvironmentStep x = environment_invert(first, rows, y.index, columns, u.x);
    const uint left = x.index << shift;
    const uint top = y.index << shift;
    const uint right = min(left + (1u << shift), width);
    const uint bottom = min(top + (1u << shift), height);

    // Uniform by solid angle within the rows: sin^2(theta / 2) = (1 - cos theta) / 2 is linear in it.
    // Measured from the nearer pole, where it keeps its digits.
    const bool south = 2u * top >= height;
    const vec2 row = south ? vec2(height - top, height - bottom) : vec2(top, bottom);
    const float half_step = 0.5 * MATH_PI / float(height);
    const vec2 edges = sin(half_step * row);
    const float s2 = mix(edges.x * edges.x, edges.y * edges.y, y.fraction);
    const float sin_half = sqrt(s2);
    const float cos_half = math_safe_sqrt(1.0 - s2);
    const float polar = atan(sin_half, cos_half) / half_step; // in rows
    const float sin_theta = 2.0 * sin_half * cos_half;
    const float cos_theta = 1.0 - 2.0 * s2;
    const float column = mix(float(left), float(right), x.fraction);
    const float phi = (column / float(width) - 0.5) * (2.0 * MATH_PI);

    LightSample s = light_sample_none();
    const float up = south ? -cos_theta : cos_theta;
    s.wi = environment_to_world(vec3(sin_theta * cos(phi), up, sin_theta * sin(phi)));
    s.distance = LIGHT_FAR;
    const vec4 texel = environment_filter(vec2(column, south ? float(height) - polar : polar));
    s.radiance = texel.rgb * frame.environment_scale;
    s.pdf = uintBitsToFloat(fetch_environment(top * width + left).w);
    return s;
}

// Uniform over the sphere: light_sample knows no surface, and BSDF sampling is the better half of MIS here.
LightSample light_environment_constant_sample(vec2 u) {
    LightSample s = light_sample_none();
    s.wi = warps_sphere(u);
    s.distance = LIGHT_FAR;
    s.radiance = frame.background;
    s.pdf = warps_sphere_pdf();
    return s;
}

LightSample light_environment_sample(vec2 u) {
    if (has_feature(FEATURE_ENVIRONMENT_MAP)) return light_environment_map_sample(u);
    return light_environment_constant_sample(u);
}

#endif
