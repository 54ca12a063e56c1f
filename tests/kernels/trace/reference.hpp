// The closest hit by brute force: the kernels' own watertight test (Woop, Benthin, Wald 2013), on the CPU, on
// every triangle. Floats round the same way on both sides, so hits must agree in every bit.
#pragma once

#include "bvh/bvh.hpp"
#include "shaders/shared/path.glsl.h"

#include <cmath>
#include <glm/glm.hpp>
#include <span>

namespace ajar::test {

struct ReferenceHit {
    float t = 3.0e38f;
    std::uint32_t triangle = shared::NO_TRIANGLE;
    float u = 0;
    float v = 0;
    bool back_face = false;
};

class ReferenceRay {
  public:
    ReferenceRay(const glm::vec3& origin, const glm::vec3& direction) : origin_(origin) {
        const glm::vec3 size = glm::abs(direction);
        main_ = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
        const glm::vec3 d = permute(direction);
        shear_ = glm::vec3(d.x / d.z, d.y / d.z, 1.0f / d.z);
    }

    // The lower triangle wins at equal distance, as in the kernels.
    void test(const shared::TriangleRecord& triangle, std::uint32_t index, ReferenceHit& hit) const {
        const glm::vec3 a = permute(bvh::record_vertex(triangle, 0) - origin_);
        const glm::vec3 b = permute(bvh::record_vertex(triangle, 1) - origin_);
        const glm::vec3 c = permute(bvh::record_vertex(triangle, 2) - origin_);
        const float ax = a.x - shear_.x * a.z, ay = a.y - shear_.y * a.z;
        const float bx = b.x - shear_.x * b.z, by = b.y - shear_.y * b.z;
        const float cx = c.x - shear_.x * c.z, cy = c.y - shear_.y * c.z;
        const float u = cx * by - cy * bx;
        const float v = ax * cy - ay * cx;
        const float w = bx * ay - by * ax;
        if ((u < 0 || v < 0 || w < 0) && (u > 0 || v > 0 || w > 0)) return;
        const float determinant = u + v + w;
        if (determinant == 0) return;
        const float inverse = 1.0f / determinant;
        const float t = (u * a.z + v * b.z + w * c.z) * shear_.z * inverse;
        const float reach =
            std::max(std::abs(a.z), std::max(std::abs(b.z), std::abs(c.z))) * std::abs(shear_.z);
        if (!(t > reach * shared::TRIANGLE_T_ERROR)) return;
        const bool closer =
            t < hit.t || (t == hit.t && hit.triangle != shared::NO_TRIANGLE && index < hit.triangle);
        if (closer) hit = {t, index, v * inverse, w * inverse, (determinant < 0) != (shear_.z < 0)};
    }

  private:
    glm::vec3 permute(const glm::vec3& p) const { return {p[(main_ + 1) % 3], p[(main_ + 2) % 3], p[main_]}; }

    glm::vec3 origin_;
    glm::vec3 shear_;
    int main_ = 2;
};

// `there` says of a hit whether it counts.
template <class There> ReferenceHit reference_closest(std::span<const shared::TriangleRecord> triangles,
                                                      const glm::vec3& origin, const glm::vec3& direction,
                                                      There there) {
    const ReferenceRay ray(origin, direction);
    ReferenceHit hit;
    for (std::uint32_t i = 0; i < triangles.size(); ++i) {
        ReferenceHit next = hit;
        ray.test(triangles[i], i, next);
        if (next.triangle == i && there(next)) hit = next;
    }
    return hit;
}

inline ReferenceHit reference_closest(std::span<const shared::TriangleRecord> triangles,
                                      const glm::vec3& origin, const glm::vec3& direction) {
    return reference_closest(triangles, origin, direction, [](const ReferenceHit&) { return true; });
}

} // namespace ajar::test
