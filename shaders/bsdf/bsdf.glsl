// The surface's scattering: glTF 2.0, appendix B, with KHR_materials_ior and KHR_materials_specular:
//   mix(dielectric, metal, metallic), dielectric = (1 - max(Fd)) base / pi + Fd S, metal = Fm S,
// where S is the microfacet lobe and both F are Schlick's, linear in f0 and f90: one F for S, another over
// the diffuse. Local frame, z = shading normal; wo and wi unit, away from the surface; reflection only. See
// shaders/bsdf/README.md.
#ifndef AJAR_BSDF_GLSL
#define AJAR_BSDF_GLSL
#include "../core/color.glsl"
#include "../material/material.glsl"
#include "diffuse.glsl"
#include "microfacet.glsl"

struct Bsdf {
    vec3 diffuse;      // albedo below the dielectric: (1 - metallic) base
    vec3 f0;           // of S: dielectric and metal mixed
    float f90;
    float coat_f0;     // of the dielectric over the diffuse lobe: greatest channel
    float coat_f90;
    float alpha;       // GGX width; below DELTA_ALPHA: S is a mirror
};

struct BsdfValue {
    vec3 f;    // 1/sr, without the cosine
    float pdf; // of bsdf_sample, by solid angle, 1/sr
};

struct BsdfSample {
    vec3 wi;
    vec3 weight; // f cos / pdf; 0: absorbed
    float pdf;   // by solid angle, 1/sr; 0: delta or absorbed
    bool delta;
};

Bsdf bsdf_make(MaterialPoint m) {
    Bsdf b;
    b.diffuse = (1.0 - m.metallic) * m.base_color.rgb;
    b.f0 = mix(m.f0_dielectric, m.base_color.rgb, m.metallic);
    b.f90 = mix(m.f90_dielectric, 1.0, m.metallic);
    b.coat_f0 = math_max3(m.f0_dielectric);
    b.coat_f90 = m.f90_dielectric;
    b.alpha = m.alpha_ggx;
    return b;
}

// Lambert's, albedo 1.
Bsdf bsdf_white() { return Bsdf(vec3(1.0), vec3(0.0), 0.0, 0.0, 0.0, 1.0); }

bool bsdf_is_mirror(Bsdf b) { return has_feature(FEATURE_DELTA) && b.alpha < DELTA_ALPHA; }

// Probability of sampling S rather than the diffuse lobe: their albedos, roughly. The rougher, the less a
// grazing wo meets microfacets at a grazing angle. Exactly 0 or 1 where only one lobe is there.
float bsdf_specular_pmf(Bsdf b, vec3 wo) {
    const float grazing = math_pow5(1.0 - wo.z) * (1.0 - b.alpha);
    const float specular = color_luminance(b.f0 + (b.f90 - b.f0) * grazing);
    const float diffuse = color_luminance(b.diffuse);
    return specular > 0.0 ? specular / (specular + diffuse) : 0.0;
}

BsdfValue bsdf_eval_pdf(Bsdf b, vec3 wo, vec3 wi) {
    const bool above = wo.z > 0.0 && wi.z > 0.0;
    BsdfValue value = BsdfValue(diffuse_eval(b.diffuse), diffuse_pdf(wi));
    if (has_feature(FEATURE_SPECULAR)) {
        const MicrofacetValue s = microfacet_eval(max(b.alpha, DELTA_ALPHA), wo, wi);
        const float schlick = math_pow5(1.0 - clamp(s.wo_dot_h, 0.0, 1.0));
        const float scatter = bsdf_is_mirror(b) ? 0.0 : 1.0;
        value.f *= 1.0 - mix(b.coat_f0, b.coat_f90, schlick);
        value.f += mix(b.f0, vec3(b.f90), schlick) * (scatter * s.f);
        value.pdf = mix(value.pdf, scatter * s.pdf, bsdf_specular_pmf(b, wo));
    }
    value.f = above ? value.f : vec3(0.0);
    value.pdf = above ? value.pdf : 0.0;
    return value;
}

vec3 bsdf_eval(Bsdf b, vec3 wo, vec3 wi) { return bsdf_eval_pdf(b, wo, wi).f; }
float bsdf_pdf(Bsdf b, vec3 wo, vec3 wi) { return bsdf_eval_pdf(b, wo, wi).pdf; }

// One-sample model (Veach 1997, section 9.2.4): one lobe is picked by u_lobe, all count in the density.
BsdfSample bsdf_sample(Bsdf b, vec3 wo, vec2 u, float u_lobe) {
    vec3 wi = diffuse_sample(u);
    if (!has_feature(FEATURE_SPECULAR)) { // f cos / pdf: cosine and pi cancel
        const float there = wo.z > 0.0 && wi.z > 0.0 ? 1.0 : 0.0;
        return BsdfSample(wi, there * b.diffuse, there * diffuse_pdf(wi), false);
    }
    const float pmf = bsdf_specular_pmf(b, wo);
    const bool specular = u_lobe < pmf;
    const bool mirror = bsdf_is_mirror(b);
    if (specular) {
        const vec3 h = microfacet_sample_normal(max(b.alpha, DELTA_ALPHA), wo, u);
        wi = mirror ? vec3(-wo.xy, wo.z) : 2.0 * dot(wo, h) * h - wo;
    }
    const BsdfValue value = bsdf_eval_pdf(b, wo, wi);
    BsdfSample s = BsdfSample(wi, vec3(0.0), value.pdf, false);
    if (value.pdf > 0.0) s.weight = value.f * (wi.z / value.pdf);
    if (specular && mirror && wo.z > 0.0) {
        s.weight = mix(b.f0, vec3(b.f90), math_pow5(1.0 - wo.z)) / pmf;
        s.pdf = 0.0;
        s.delta = true;
    }
    return s;
}

// For denoisers and the albedo image: what comes back of light from all around at normal incidence, without
// masking.
vec3 bsdf_albedo(Bsdf b) { return min(b.diffuse * (1.0 - b.coat_f0) + b.f0, vec3(1.0)); }

#endif
