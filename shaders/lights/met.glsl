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

// How a path came to what it met.
struct MetWay {
    bool camera; // straight from the camera
    bool every;  // from a vertex that had shadow rays for every light
};

// What is kept of the vertex that the path left last. To be read before the next one's takes its place.
uvec2 met_left(PathState path) { return LIGHT_SAMPLER_LOOKS ? path_left_load(path.home) : uvec2(0u); }

// Probability with which that vertex, `left`, would have picked the light that the path met.
float met_pmf(PathState path, uvec2 left, uint light, MetWay way) {
    if (STRATEGY == STRATEGY_BSDF) return 0.0;
    if (way.every) return 1.0;
    return light_sampler_pmf(receiver_unpack(path.origin, left), light);
}

vec3 met_environment(PathState path, uvec2 left, MetWay way) {
    if (!has_feature(FEATURE_ANY_ENVIRONMENT)) return vec3(0.0);
    vec4 radiance_pdf = environment_lookup(path.direction);
    float pmf = met_pmf(path, left, frame.environment_light, way);
    return radiance_pdf.rgb * mis_emission_weight(path.pdf, pmf * radiance_pdf.a);
}

vec3 met_surface(PathState path, uvec2 left, Vertex v, MetWay way) {
    float light_pdf = 0.0;
    if (has_feature(FEATURE_EMISSIVE_TRIANGLES)) {
        float pdf = light_pdf_triangle(path.origin, path.direction, path.triangle);
        bool is_light = v.surface.light != NO_LIGHT && path.pdf > 0.0; // else nothing is to be weighed
        light_pdf = is_light ? pdf * met_pmf(path, left, v.surface.light, way) : 0.0;
    }
    return vertex_emission(v) * mis_emission_weight(path.pdf, light_pdf);
}

// Spheres and suns, which are in no hierarchy; `limit`: where the ray ends.
vec3 met_soft_lights(PathState path, uvec2 left, float limit, MetWay way) {
    vec3 sum = vec3(0.0);
    uvec2 found = soft_meet(path.origin, path.direction, limit, way.camera);
    while (any(notEqual(found, uvec2(0u)))) {
        uint light = soft_next(found);
        vec4 radiance_pdf = soft_lookup(light, path.origin);
        float pmf = met_pmf(path, left, light, way);
        sum += radiance_pdf.rgb * mis_emission_weight(path.pdf, pmf * radiance_pdf.a);
    }
    return sum;
}

// All that comes from where the path ends: the surface it met, or afar; and from what lies before that.
vec3 met_at_surface(PathState path, uvec2 left, MetWay way) {
    Vertex v = vertex_at(path);
    vec3 light = met_surface(path, left, v, way);
    if (!has_feature(FEATURE_SOFT_LIGHTS)) return light;
    float limit = soft_limit(length(v.surface.position - path.origin), !v.surface.emits);
    return light + met_soft_lights(path, left, limit, way);
}
vec3 met_from_afar(PathState path, uvec2 left, MetWay way) {
    vec3 light = met_environment(path, left, way);
    if (!has_feature(FEATURE_SOFT_LIGHTS)) return light;
    return light + met_soft_lights(path, left, LIGHT_FAR, way);
}

void met_add(PathState path, vec3 light) {
    if (any(notEqual(light, vec3(0.0)))) radiance_add(path.home, path.beta * light);
}

#endif
