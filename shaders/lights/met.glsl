// Light that BSDF sampling met, weighted by what light sampling would have made of it (mis.glsl): the
// environment, emissive surfaces, spheres and suns.
#ifndef AJAR_MET_GLSL
#define AJAR_MET_GLSL
#include "../core/paths.glsl"
#include "../material/vertex.glsl"
#include "light.glsl"
#include "light_sampler.glsl"
#include "mis.glsl"
#include "soft.glsl"

// What is kept of the vertex that the path left last. To be read before the next one's takes its place.
uvec2 met_left(PathState path) { return LIGHT_SAMPLER_LOOKS ? path_left_load(path.home) : uvec2(0u); }

// Probability with which that vertex, `left`, would have picked the light that the path met.
// `every`: it had shadow rays for every light.
float met_pmf(PathState path, uvec2 left, uint light, bool every) {
    if (STRATEGY == STRATEGY_BSDF) return 0.0;
    if (every) return 1.0;
    return light_sampler_pmf(receiver_unpack(path.origin, left), light);
}

vec3 met_environment(PathState path, uvec2 left, bool every) {
    if (!has_feature(FEATURE_ANY_ENVIRONMENT)) return vec3(0.0);
    vec4 radiance_pdf = environment_lookup(path.direction);
    float pmf = met_pmf(path, left, frame.environment_light, every);
    return radiance_pdf.rgb * mis_emission_weight(path.pdf, pmf * radiance_pdf.a);
}

vec3 met_surface(PathState path, uvec2 left, Vertex v, bool every) {
    float light_pdf = 0.0;
    if (has_feature(FEATURE_EMISSIVE_TRIANGLES)) {
        float pdf = light_pdf_triangle(path.origin, path.direction, path.triangle);
        bool is_light = v.surface.light != NO_LIGHT && path.pdf > 0.0; // else nothing is to be weighed
        light_pdf = is_light ? pdf * met_pmf(path, left, v.surface.light, every) : 0.0;
    }
    return vertex_emission(v) * mis_emission_weight(path.pdf, light_pdf);
}

// Spheres and suns, which are in no hierarchy; `limit`: where the ray ends.
vec3 met_soft_lights(PathState path, uvec2 left, float limit, bool camera, bool every) {
    vec3 sum = vec3(0.0);
    uvec2 found = soft_meet(path.origin, path.direction, limit, camera);
    while (any(notEqual(found, uvec2(0u)))) {
        uint light = soft_next(found);
        vec4 radiance_pdf = soft_lookup(light, path.origin);
        float pmf = met_pmf(path, left, light, every);
        sum += radiance_pdf.rgb * mis_emission_weight(path.pdf, pmf * radiance_pdf.a);
    }
    return sum;
}

// All that comes from where the path ends: the surface it met, or afar; and from what lies before that.
// `camera`: it came straight from there.
vec3 met_at_surface(PathState path, uvec2 left, bool camera, bool every) {
    Vertex v = vertex_at(path);
    vec3 light = met_surface(path, left, v, every);
    if (!has_feature(FEATURE_SOFT_LIGHTS)) return light;
    float limit = soft_limit(length(v.surface.position - path.origin), !v.surface.emits);
    return light + met_soft_lights(path, left, limit, camera, every);
}
vec3 met_from_afar(PathState path, uvec2 left, bool camera, bool every) {
    vec3 light = met_environment(path, left, every);
    if (!has_feature(FEATURE_SOFT_LIGHTS)) return light;
    return light + met_soft_lights(path, left, LIGHT_FAR, camera, every);
}

void met_add(PathState path, vec3 light) {
    if (any(notEqual(light, vec3(0.0)))) radiance_add(path.home, path.beta * light);
}

#endif
