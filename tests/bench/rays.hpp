// The three kinds of rays that are timed, made from one camera.
#pragma once

#include "bench_scenes.hpp"
#include "shaders/shared/bvh.glsl.h"
#include "shaders/shared/path.glsl.h"

#include <span>

namespace ajar::bench {

// One per pixel, in Morton order of a size x size picture (a power of two).
std::vector<shared::PathState> primary_rays(const BenchScene& scene, std::uint32_t size);

// From where `hits` ended: a cosine-distributed direction each. Misses make no ray.
std::vector<shared::PathState> bounce_rays(std::span<const shared::PathState> hits,
                                           std::span<const shared::TriangleRecord> triangles,
                                           std::uint32_t seed);

// From there to a random point of the light.
std::vector<shared::ShadowRay> shadow_rays(const BenchScene& scene, std::span<const shared::PathState> hits,
                                           std::span<const shared::TriangleRecord> triangles,
                                           std::uint32_t seed);

} // namespace ajar::bench
