// Scenes to trace, made by the program itself: closed rooms with a light under the ceiling.
#pragma once

#include "bvh/bvh.hpp"

#include <string>

namespace ajar::bench {

struct BenchScene {
    std::string name;
    std::vector<bvh::Triangle> triangles;
    glm::vec3 eye, target;                    // metres
    float yfov = 0.8f;                        // radians
    glm::vec3 light_corner, light_u, light_v; // where shadow rays go
};

// About 1,000 triangles: a Cornell box with two tessellated spheres.
BenchScene small_scene();
// More than half a million: a room with rough walls, displaced organic shapes and foliage.
BenchScene big_scene();
// A glTF file, seen by its camera or framed; shadow rays go to a square above it.
BenchScene load_scene(const std::string& path);

} // namespace ajar::bench
