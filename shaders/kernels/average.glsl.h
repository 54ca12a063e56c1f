// average: what a side of a patch is made of, as means over it: the radiance that it emits, and the share of
// diffuse light from all around that it sends back, by the path tracer's own materials:
//   rho = E[ f cos / pdf ] over points of the side, wo by the cosine, wi as bsdf_sample has it,
// which for Lambert's law is the albedo itself, whatever the directions. Emission as along the normal, which
// no material makes depend on the direction. Where the surface is there with a probability (alpha), means are
// of what is there. One thread per side; no other reads or writes.
#ifndef AJAR_AVERAGE_GLSL_H
#define AJAR_AVERAGE_GLSL_H
#include "../shared/element.glsl.h"
#include "../shared/radiosity.glsl.h"
DUAL_BEGIN

struct AverageArgs {
    SurfaceElementPtr elements; // by side
    SideValuePtr emission;      // out: W/(m^2 sr); scalar: the share of the side that is there
    SideValuePtr reflectance;   // out: rho, at most 1; scalar is left alone
    uint first_side;
    uint side_count; // of this dispatch
    uint points;     // on each
    uint pad;
};
DUAL_SIZE(AverageArgs, 40);

DUAL_END
#endif
