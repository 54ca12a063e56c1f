// How much a light counts when two samplings may find it (Veach and Guibas 1995): weights that sum to 1.
// SPEC_STRATEGY leaves one of the two out, SPEC_HEURISTIC chooses the exponent.
#ifndef AJAR_MIS_GLSL
#define AJAR_MIS_GLSL
#include "../core/variants.glsl"

// Of the sampling that has density pdf; ratios, so that squares cannot overflow.
float mis_weight(float pdf, float other) {
    float ratio = other / pdf;
    return 1.0 / (1.0 + (HEURISTIC == HEURISTIC_BALANCE ? ratio : ratio * ratio));
}

// The weight of a light that BSDF sampling met, which light sampling would have found with density light_pdf.
float mis_emission_weight(float bsdf_pdf, float light_pdf) {
    if (STRATEGY == STRATEGY_BSDF || bsdf_pdf == 0.0) return 1.0;
    if (STRATEGY == STRATEGY_LIGHT) return light_pdf > 0.0 ? 0.0 : 1.0;
    return mis_weight(bsdf_pdf, light_pdf);
}

#endif
