// The same scene in Embree, traced ray by ray on the calling thread.
#pragma once

#include "bvh/bvh.hpp"
#include "shaders/shared/bvh.glsl.h"
#include "shaders/shared/path.glsl.h"

#include <memory>
#include <span>

namespace ajar::bench {

struct EmbreeHit {
    float t = 0;
    std::uint32_t triangle = shared::NO_TRIANGLE;
};

class EmbreeTracer {
  public:
    explicit EmbreeTracer(
        std::span<const shared::TriangleRecord> triangles); // hits name triangles by this order
    ~EmbreeTracer();
    EmbreeTracer(const EmbreeTracer&) = delete;
    EmbreeTracer& operator=(const EmbreeTracer&) = delete;

    void intersect(std::span<const shared::PathState> rays, std::span<EmbreeHit> hits) const;
    void occluded(std::span<const shared::ShadowRay> rays, std::span<char> open) const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

} // namespace ajar::bench
