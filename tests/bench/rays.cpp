#include "rays.hpp"

#include "kernels/trace/soups.hpp"

namespace ajar::bench {
namespace {

using test::uniform;

// Even bits of a Morton code.
std::uint32_t compact(std::uint32_t code) {
    std::uint32_t out = 0;
    for (std::uint32_t bit = 0; bit < 16; ++bit) out |= (code >> (2 * bit) & 1) << bit;
    return out;
}

// Where a path ended: slightly on the side it came from, so that a tracer without exclusion does not find the
// same surface again. Both tracers start there.
struct Departure {
    glm::vec3 position;
    glm::vec3 normal;
};

Departure depart(const shared::PathState& hit, std::span<const shared::TriangleRecord> triangles) {
    const shared::TriangleRecord& t = triangles[hit.triangle];
    const glm::vec3 p0 = bvh::record_vertex(t, 0), p1 = bvh::record_vertex(t, 1),
                    p2 = bvh::record_vertex(t, 2);
    glm::vec3 normal = glm::normalize(glm::cross(p1 - p0, p2 - p0));
    if (glm::dot(normal, hit.direction) > 0) normal = -normal;
    const glm::vec3 position = (1 - hit.u - hit.v) * p0 + hit.u * p1 + hit.v * p2;
    const glm::vec3 size = glm::max(glm::abs(p0), glm::max(glm::abs(p1), glm::abs(p2)));
    return {position + normal * (glm::dot(glm::abs(normal), size) * 2e-6f), normal};
}

} // namespace

std::vector<shared::PathState> primary_rays(const BenchScene& scene, std::uint32_t size) {
    const glm::vec3 back = glm::normalize(scene.eye - scene.target);
    const glm::vec3 right = glm::normalize(glm::cross(glm::vec3(0, 1, 0), back));
    const glm::vec3 up = glm::cross(back, right);
    const float scale = std::tan(scene.yfov / 2);
    test::Random random(7);
    std::vector<shared::PathState> rays;
    for (std::uint32_t i = 0; i < size * size; ++i) {
        const float x = (2 * (float(compact(i)) + uniform(random)) / float(size) - 1) * scale;
        const float y = (1 - 2 * (float(compact(i >> 1)) + uniform(random)) / float(size)) * scale;
        rays.push_back(test::make_ray(scene.eye, glm::normalize(x * right + y * up - back)));
    }
    return rays;
}

std::vector<shared::PathState> bounce_rays(std::span<const shared::PathState> hits,
                                           std::span<const shared::TriangleRecord> triangles,
                                           std::uint32_t seed) {
    test::Random random(seed);
    std::vector<shared::PathState> rays;
    for (const shared::PathState& hit : hits) {
        const glm::vec3 toward = test::random_direction(random);
        if (hit.triangle == shared::NO_TRIANGLE) continue;
        const Departure from = depart(hit, triangles);
        const glm::vec3 direction = from.normal * 1.0001f + toward;
        shared::PathState ray = test::make_ray(from.position, glm::normalize(direction));
        ray.leaves = hit.triangle;
        rays.push_back(ray);
    }
    return rays;
}

std::vector<shared::ShadowRay> shadow_rays(const BenchScene& scene, std::span<const shared::PathState> hits,
                                           std::span<const shared::TriangleRecord> triangles,
                                           std::uint32_t seed) {
    test::Random random(seed);
    std::vector<shared::ShadowRay> rays;
    for (const shared::PathState& hit : hits) {
        const float u = uniform(random), v = uniform(random);
        if (hit.triangle == shared::NO_TRIANGLE) continue;
        const Departure from = depart(hit, triangles);
        const glm::vec3 way = scene.light_corner + u * scene.light_u + v * scene.light_v - from.position;
        const float distance = glm::length(way);
        if (glm::dot(way, from.normal) <= 0) continue;
        shared::ShadowRay ray{};
        ray.origin = from.position;
        ray.direction = way / distance;
        ray.reach = distance * 0.999f;
        ray.leaves = hit.triangle;
        rays.push_back(ray);
    }
    return rays;
}

} // namespace ajar::bench
