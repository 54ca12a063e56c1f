// What happens where a path met the scene; the estimator is in shade.glsl.h.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shade.glsl.h"
#include "../core/paths.glsl"
#include "../core/sampler.glsl"
#include "../core/segment.glsl"
#include "../core/scan.glsl"
#include "../lights/light.glsl"
#include "../lights/light_sampler.glsl"
#include "../lights/met_lists.glsl"
#include "../material/vertex.glsl"

layout(push_constant, scalar) uniform ArgsBlock { ShadeArgs args; };

const uint TASK = OPTION & ~SHADE_WHITE;
const bool WHITE = (OPTION & SHADE_WHITE) != 0u;

// Whether what was met may send light to the path: not where the path begins there.
const bool LOOKS = !WHITE && TASK != SHADE_LIGHT && TASK != SHADE_LEARN;

// The light to connect to: a picked one, or, where every one has its turn, this dispatch's.
LightPick pick_light(Vertex v, uvec2 left, float u) {
    if (TASK == SHADE_LIGHT) return LightPick(args.light, 1.0, u, 0.0);
    return light_sampler_pick(receiver_unpack(v.surface.departure, left), u);
}

// Whether light samplers look at vertices, and what they see of one (receiver.glsl).
const bool LEAVES = LIGHT_SAMPLER_LOOKS && STRATEGY != STRATEGY_BSDF && TASK != SHADE_SCATTER &&
                    TASK != SHADE_LIGHT;
uvec2 receiver_words(Vertex v) {
    if (!LEAVES) return uvec2(0u);
    uint lobe = 0u;
    if (has_feature(FEATURE_SPECULAR))
        lobe = receiver_pack_lobe(frame_to_world(v.frame, vec3(-v.wo.xy, v.wo.z)), v.bsdf.alpha,
                                  bsdf_specular_pmf(v.bsdf, v.wo));
    return uvec2(octahedral_encode(v.surface.ng), lobe);
}

// A shadow ray to one light. False when nothing can come of it.
bool connect_light(PathState path, Vertex v, uvec2 left, Sampler points, uint dimension, out ShadowRay ray) {
    if (TASK == SHADE_LIGHT) dimension += DIM_PER_LIGHT * (args.light + 1u);
    vec2 u = sampler_2d(points, dimension + DIM_LIGHT);
    LightPick pick = pick_light(v, left, u.x);
    u.x = light_pick_rest(pick, sampler_1d(points, dimension + DIM_LIGHT_DIGITS));
    LightSample light = light_sample(pick.light, v.surface.departure, u);
    BsdfValue value = bsdf_eval_pdf(v.bsdf, v.wo, frame_to_local(v.frame, light.wi));
    float light_pdf = light.pdf * pick.pmf;
    float weight = STRATEGY == STRATEGY_MIS && !light.delta ? mis_weight(light_pdf, value.pdf) : 1.0;
    float cosine = dot(v.frame.n, light.wi);
    bool above = cosine > 0.0 && dot(v.surface.ng, light.wi) > 0.0 && light_pdf > 0.0;
    ray.origin = v.surface.departure;
    ray.leaves = path.triangle;
    ray.direction = light.wi;
    ray.reach = light.reach;
    ray.contribution = path.beta * value.f * light.radiance * (cosine * weight / max(light_pdf, 1e-37));
    ray.home = path.home;
    ray.instance = path.instance;
    if (TASK == SHADE_LEARN)
        ray.counter = visibility_counter(
            visibility_cell(v.surface.departure, octahedral_decode(left.x)),
            light_tree_trail(pick.light));
    return above && any(greaterThan(ray.contribution, vec3(0.0)));
}

// The next direction, into `path`. False when the path ends: absorbed, or by Russian roulette.
bool scatter(inout PathState path, Vertex v, Sampler points, uint dimension) {
    float u_lobe = has_feature(FEATURE_SPECULAR) ? sampler_1d(points, dimension + DIM_BSDF_LOBE) : 0.0;
    BsdfSample next = bsdf_sample(v.bsdf, v.wo, sampler_2d(points, dimension + DIM_BSDF), u_lobe);
    path.direction = frame_to_world(v.frame, next.wi);
    path.origin = v.surface.departure;
    path.leaves = path.triangle;
    path.pdf = next.delta ? 0.0 : next.pdf;
    path.beta *= next.weight;
    bool alive = any(greaterThan(path.beta, vec3(0.0))) && dot(path.direction, v.surface.ng) > 0.0;
    if (args.segments.bounce >= frame.rr_depth) {
        float survival = min(math_max3(path.beta), 1.0);
        alive = alive && sampler_1d(points, dimension + DIM_ROULETTE) < survival;
        path.beta /= survival;
    }
    return alive;
}

bool shade(inout PathState path, out ShadowRay ray, out bool connects, out uvec2 left) {
    Vertex v = vertex_at(path);
    if (WHITE) v.bsdf = bsdf_white();
    Sampler points = segment_sampler(args.segments, path.home);
    uint dimension = sampler_bounce(args.segments.bounce);
    left = receiver_words(v);
    connects = false;
    if (STRATEGY != STRATEGY_BSDF && TASK != SHADE_SCATTER)
        connects = connect_light(path, v, left, points, dimension, ray);
    return TASK != SHADE_LIGHT && scatter(path, v, points, dimension);
}

void main() {
    uint segment = segment_index(args.segments);
    if (segment == NO_SEGMENT) return;
    uint first = segment * SEGMENT_SIZE;
    HitLists hits = hit_lists(first, segments[segment].paths,
                              (LOOKS ? met_lists_wanted() : 0u) | (WHITE ? HIT_LISTS_ALL_SCATTER : 0u));
    if (LOOKS) met_lists_add(first, hits, MetWay(args.segments.bounce == 0u, TASK == SHADE_SCATTER));
    uint count = args.segments.bounce <= frame.max_bounces ? hits.scattering : 0u;
    uint kept = 0u;
    uint shadows = 0u;
    for (uint base = 0u; base < count; base += WORKGROUP_SIZE) {
        uint i = base + gl_LocalInvocationID.x;
        PathState path = path_load(first + hit_scattering[min(i, count - 1u)]);
        ShadowRay ray;
        bool connects;
        uvec2 left;
        uint home = path.home;
        bool alive = shade(path, ray, connects, left) && i < count;
        connects = connects && i < count;
        // A CPU's lanes past the end store the same once more; elsewhere that would be a race.
        if (LEAVES && (PATH_TEXELS != 0u || i < count)) path_left_store(home, left);
        if (TASK != SHADE_LIGHT) {
            Scan survivors = scan_keepers(alive);
            path_store(first + kept + scan_place(survivors, alive), path);
            kept += survivors.total;
        }
        if (TASK != SHADE_SCATTER) {
            Scan connections = scan_keepers(connects);
            uint slot = first + shadows + scan_place(connections, connects);
            shadow_ray_store(slot, ray);
            if (TASK == SHADE_LEARN) shadow_ray_counter_store(slot, ray.counter);
            shadows += connections.total;
        }
        if (base + WORKGROUP_SIZE >= count) break;
    }
    if (gl_LocalInvocationID.x == 0u) {
        if (TASK != SHADE_LIGHT) segments[segment].paths = kept;
        segments[segment].shadows = shadows;
    }
}
