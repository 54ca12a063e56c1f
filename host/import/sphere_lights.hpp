// Meshes that emit as spheres: marked by {"ajar_sphere": true} in the extras of a mesh or a node, and
// checked to be one.
#pragma once

#include "import/document.hpp"
#include "scene/scene.hpp"

#include <cstdint>
#include <map>
#include <optional>
#include <string>

namespace ajar::gltf {

struct FittedSphere {
    glm::vec3 center{0};
    float radius = 0; // of the farthest vertex
    std::string flaw; // why the mesh is no such sphere; empty: it is
};

// The sphere through a mesh's triangles, in the mesh's own frame: all corners within 1 % of the same
// distance from its centre, closed, facing outwards, all of one material whose emission is the same
// everywhere.
FittedSphere fit_sphere(const Mesh& mesh, const std::vector<Material>& materials);

class SphereLights {
  public:
    // Both must outlive this.
    SphereLights(Document& document, const Scene& scene) : document_(document), scene_(scene) {}

    // Makes the instance a sphere that emits, or warns that it is none and leaves it as it is.
    void mark(Instance& instance);

  private:
    Document& document_;
    const Scene& scene_;
    std::map<std::uint32_t, FittedSphere> fitted_; // by Scene::meshes
};

} // namespace ajar::gltf
