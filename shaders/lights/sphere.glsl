// Sphere: directions uniform within the cone that it covers (Shirley, Wang and Zimmerman 1996), seen from
// inside over the whole sphere of directions. A point or spot light with a radius is a sphere of radiance
// intensity / (pi radius^2), so that from far away it is the same light; a spot's profile and its range are
// those of the direction and the distance to the centre.
#ifndef AJAR_LIGHTS_SPHERE_GLSL
#define AJAR_LIGHTS_SPHERE_GLSL
#include "../core/frame.glsl"
#include "../core/warps.glsl"
#include "spot.glsl"

// The share of a distance that lies safely between a sphere and the triangles of its mesh, just inside:
// well above the rounding of distances. What the radius needs besides, it has from the host
// (light_table.cpp).
const float SPHERE_SKIN = 1e-5;

struct SphereSeen {
    vec3 axis;      // unit, towards the centre
    float distance; // to the centre, metres
    float outside;  // distance^2 - radius^2: negative within
    float cap;      // 1 - cos of the cone's half angle; 2, all directions, from within
    float pdf;      // of each direction in it, 1/sr; 0: nothing to be seen
};

SphereSeen light_sphere_seen(LightRecord light, vec3 point) {
    const vec3 to_center = light.p0 - point;
    const float distance2 = dot(to_center, to_center);
    const float radius2 = light.extent * light.extent;
    SphereSeen seen;
    seen.distance = sqrt(distance2);
    seen.axis = to_center / seen.distance;
    seen.outside = distance2 - radius2;
    const bool within = seen.outside <= 0.0;
    // sin^2 / (1 + cos): 1 - cos has no digits left for small cones.
    const float cosine = math_safe_sqrt(seen.outside / distance2);
    seen.cap = within ? 2.0 : radius2 / (distance2 * (1.0 + cosine));
    seen.pdf = warps_cone_pdf(seen.cap);
    // A sphere that is a mesh shines outwards only; its own triangles, just inside, must not see it.
    const bool there = !within || (light.kind & LIGHT_LAMP) != 0u;
    const bool valid = distance2 > LIGHT_NEAR_SQUARED && distance2 <= LIGHT_FAR && seen.pdf <= LIGHT_FAR;
    seen.pdf = there && valid ? seen.pdf : 0.0;
    seen.axis = seen.pdf > 0.0 ? seen.axis : vec3(0.0, 0.0, 1.0);
    return seen;
}

vec3 light_sphere_radiance(LightRecord light, SphereSeen seen) {
    const float window = light_range_window(seen.distance * seen.distance, light.p2.x);
    return seen.pdf > 0.0 ? light.radiance * (window * light_spot_profile(light, seen.axis)) : vec3(0.0);
}

// Distance to the surface along a ray that passes the centre at right angles after `along`, `aside2` (a
// square) beside it: to the front of the sphere, or to its back from within. Meaningless for a miss.
float light_sphere_distance(float along, float aside2, float radius, float outside) {
    const float far = along + math_safe_sqrt(radius * radius - aside2);
    return outside > 0.0 ? outside / far : far; // not along - sqrt(), which cancels
}

LightSample light_sphere_sample(LightRecord light, vec3 point, vec2 u) {
    const SphereSeen seen = light_sphere_seen(light, point);
    const float h = u.x * seen.cap;
    const float sine2 = h * (2.0 - h);
    LightSample s = light_sample_none();
    s.wi = frame_to_world(frame_make(seen.axis), warps_cap(h, u.y));
    s.distance = light_sphere_distance(seen.distance * (1.0 - h), seen.distance * seen.distance * sine2,
                                       light.extent, seen.outside);
    s.radiance = light_sphere_radiance(light, seen);
    s.pdf = seen.pdf;
    s.delta = (light.kind & LIGHT_UNMET) != 0u;
    s.distance = s.pdf > 0.0 ? s.distance : 0.0;
    s.reach = s.distance * (1.0 - SPHERE_SKIN);
    return s;
}

#endif
