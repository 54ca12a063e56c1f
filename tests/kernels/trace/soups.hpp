// Triangles and rays at random, for tests.
#pragma once

#include "bvh/bvh.hpp"
#include "shaders/shared/path.glsl.h"

#include <random>

namespace ajar::test {

using Random = std::mt19937;

// In [lower, upper).
inline float uniform(Random& random, float lower = 0, float upper = 1) {
    return lower + (upper - lower) * float(random() >> 8) * 0x1p-24f;
}

inline glm::vec3 random_point(Random& random, float extent = 1) {
    const float x = uniform(random, -extent, extent), y = uniform(random, -extent, extent);
    return {x, y, uniform(random, -extent, extent)};
}

inline glm::vec3 random_direction(Random& random) {
    for (;;) {
        const glm::vec3 d = random_point(random);
        const float length = glm::length(d);
        if (length > 0.01f && length <= 1) return d / length;
    }
}

// Triangles of very different sizes around the origin.
inline std::vector<bvh::Triangle> random_soup(std::uint32_t count, std::uint32_t seed) {
    Random random(seed);
    std::vector<bvh::Triangle> triangles(count);
    for (bvh::Triangle& triangle : triangles) {
        const glm::vec3 center = random_point(random);
        const float size = std::pow(10.0f, uniform(random, -2.5f, 0)) * (count < 10 ? 3.0f : 1.0f);
        for (glm::vec3& vertex : triangle.vertices) vertex = center + random_point(random, size);
    }
    return triangles;
}

inline shared::PathState make_ray(const glm::vec3& origin, const glm::vec3& direction) {
    shared::PathState path{};
    path.origin = origin;
    path.direction = direction;
    path.leaves = path.triangle = shared::NO_TRIANGLE;
    return path;
}

// A point on a triangle, inside, on an edge or at a vertex.
inline glm::vec3 random_target(Random& random, const bvh::Triangle& triangle) {
    const glm::vec3(&p)[3] = triangle.vertices;
    float u = uniform(random), v = uniform(random);
    if (u + v > 1) u = 1 - u, v = 1 - v;
    switch (random() % 8) {
    case 0: return p[random() % 3];
    case 1: return p[0] + u * (p[1] - p[0]);
    default: return p[0] + u * (p[1] - p[0]) + v * (p[2] - p[0]);
    }
}

// Rays of every kind: free, aimed at triangles, along axes, starting outside, inside and in the plane of a
// triangle.
inline std::vector<shared::PathState> random_rays(const std::vector<bvh::Triangle>& triangles,
                                                  std::uint32_t count, std::uint32_t seed) {
    Random random(seed);
    std::vector<shared::PathState> rays;
    while (rays.size() < count) {
        const bvh::Triangle& triangle = triangles[random() % triangles.size()];
        const glm::vec3 target = random_target(random, triangle);
        glm::vec3 origin = random_point(random, random() % 2 ? 3.0f : 0.5f);
        glm::vec3 direction = target - origin;
        switch (random() % 6) {
        case 0: direction = random_direction(random); break;
        case 1: { // along an axis, through the target
            const int axis = int(random() % 3);
            direction = glm::vec3(0);
            direction[axis] = random() % 2 ? 1.0f : -1.0f;
            const float distance = origin[axis];
            origin = target;
            origin[axis] = distance;
            break;
        }
        case 2: // grazing: the origin lies in the triangle's plane
            origin =
                triangle.vertices[0] + uniform(random, -3, 3) * (triangle.vertices[1] - triangle.vertices[0]);
            direction = target - origin;
            break;
        case 3: direction[int(random() % 3)] = random() % 2 ? 0.0f : -1e-30f; break;
        default: break;
        }
        if (glm::length(direction) < 1e-6f) continue;
        rays.push_back(make_ray(origin, glm::normalize(direction)));
    }
    return rays;
}

} // namespace ajar::test
