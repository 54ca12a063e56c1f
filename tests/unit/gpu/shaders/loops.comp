// For tests: the two loop forms that kernels may use, with lanes that leave at different trips. Values are
// made inside the loop and used after it, which is what Mesa 22.3.6 gets wrong in do-while loops and in loops
// that break at their end. Collatz: out[4 i ..] = trips and peak by `for` with break, trips and peak by
// `while`.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "core/variants.glsl"
#include "core/workgroup.glsl"
#include "shared/bindings.glsl.h"

layout(push_constant, scalar) uniform Args { uint count; uint factor; uint offset; } args;
layout(set = 0, binding = BIND_PATHS, scalar) buffer Out { uint at[]; } result;

const uint LIMIT = 1000;

uint next(uint n) { return (n & 1u) == 0u ? n / 2u : 3u * n + 1u; }

uvec2 by_for(uint n) {
    uint trips = 0;
    uint peak = n;
    for (uint i = 0; i < LIMIT; ++i) {
        const uint m = next(n);
        const bool done = n == 1u;
        trips = done ? trips : i + 1u;
        peak = max(peak, done ? 0u : m);
        n = done ? n : m;
        if (done) break;
    }
    return uvec2(trips, peak);
}

uvec2 by_while(uint n) {
    uint trips = 0;
    uint peak = n;
    while (n != 1u && trips < LIMIT) {
        n = next(n);
        peak = max(peak, n);
        ++trips;
    }
    return uvec2(trips, peak);
}

// A loop in a loop, the inner one left early by `break`, as traversal does.
uint nested(uint n) {
    uint total = 0;
    for (uint outer = 0; outer < 16u; ++outer) {
        uint found = 99u;
        for (uint inner = 0; inner < 8u; ++inner) {
            const uint candidate = n + outer * 8u + inner;
            if (candidate % 7u == 3u) {
                found = candidate;
                break;
            }
        }
        if (found == 99u || found % 11u == n % 5u) break;
        total += found;
    }
    return total;
}

void main() {
    const uint i = workgroup_index() * WORKGROUP_SIZE + gl_LocalInvocationID.x;
    if (i >= args.count) return;
    const uvec2 a = by_for(i + 1u);
    const uvec2 b = by_while(i + 1u);
    result.at[5u * i] = a.x;
    result.at[5u * i + 1u] = a.y;
    result.at[5u * i + 2u] = b.x;
    result.at[5u * i + 3u] = b.y;
    result.at[5u * i + 4u] = nested(i);
}
