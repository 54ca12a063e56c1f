// Axis-aligned boxes as the builder uses them: four floats a corner, so that compilers keep them in one
// register.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>
#include <limits>

namespace ajar::bvh {

struct alignas(16) Box {
    float lower[4] = {INFINITY, INFINITY, INFINITY, INFINITY};
    float upper[4] = {-INFINITY, -INFINITY, -INFINITY, -INFINITY};

    void include(const Box& other) {
        for (int i = 0; i < 4; ++i) lower[i] = other.lower[i] < lower[i] ? other.lower[i] : lower[i];
        for (int i = 0; i < 4; ++i) upper[i] = other.upper[i] > upper[i] ? other.upper[i] : upper[i];
    }
    void include(const glm::vec3& point) {
        for (int i = 0; i < 3; ++i) {
            lower[i] = std::min(lower[i], point[i]);
            upper[i] = std::max(upper[i], point[i]);
        }
    }
    bool empty() const { return lower[0] > upper[0]; }
    // Half the surface, in double: a float would overflow from 1e19 metres on, and vanish below 1e-22.
    double half_area() const {
        if (empty()) return 0;
        const double x = double(upper[0]) - lower[0];
        const double y = double(upper[1]) - lower[1];
        const double z = double(upper[2]) - lower[2];
        return x * y + y * z + z * x;
    }
};

} // namespace ajar::bvh
