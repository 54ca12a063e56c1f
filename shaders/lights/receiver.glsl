// What light samplers know of the vertex that they pick a light for: where it is, how it is turned, and where
// it throws light that comes from its viewer's side. Kept in two words beside the path, for the same
// probability must be worked out once more when the path meets a light: pick sees what was kept, too.
#ifndef AJAR_RECEIVER_GLSL
#define AJAR_RECEIVER_GLSL
#include "../core/octahedral.glsl"
#include "../core/variants.glsl"

struct LightReceiver {
    vec3 point;     // world, metres
    vec3 normal;    // geometric, unit, on the side of the viewer
    vec3 lobe;      // unit: middle of what a microfacet lobe reflects
    float alpha2;   // its GGX width, squared
    float specular; // its share of what the vertex reflects, [0, 1)
};

// Of the lobe's word: direction 2 x 11 bits, roughness 5, share 5.
const float RECEIVER_DIRECTION = 1023.0;
const float RECEIVER_ROUGHNESS = 31.0;
const float RECEIVER_SHARE = 32.0;

uint receiver_pack_lobe(vec3 lobe, float alpha, float specular) {
    const uint direction = octahedral_encode(lobe);
    // From snorm16: rounded down, half a step is not worth an addition.
    const uint x = uint(int(direction << 16) >> 21) & 0x7ffu;
    const uint y = uint(int(direction) >> 21) & 0x7ffu;
    const uint roughness = uint(int(clamp(sqrt(alpha) * RECEIVER_ROUGHNESS + 0.5, 1.0, RECEIVER_ROUGHNESS)));
    const uint share = uint(int(min(specular * RECEIVER_SHARE, RECEIVER_SHARE - 1.0)));
    return x | y << 11 | roughness << 22 | share << 27;
}

LightReceiver receiver_unpack(vec3 point, uvec2 words) {
    LightReceiver r;
    r.point = point;
    r.normal = octahedral_decode(words.x);
    r.lobe = vec3(0.0, 0.0, 1.0);
    r.alpha2 = 1.0;
    r.specular = 0.0;
    if (has_feature(FEATURE_SPECULAR)) {
        r.lobe = octahedral_decode((words.y << 21 >> 16) | (words.y >> 11 << 21));
        const float roughness = float(int((words.y >> 22) & 31u)) * (1.0 / RECEIVER_ROUGHNESS);
        r.alpha2 = roughness * roughness;
        r.alpha2 *= r.alpha2;
        r.specular = float(int(words.y >> 27)) * (1.0 / RECEIVER_SHARE);
    }
    return r;
}

#endif
