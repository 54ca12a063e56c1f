// Between the triangles of a Scene and those of the device, which lie in leaf order.
#pragma once

#include "scene/scene.hpp"
#include "shaders/shared/element.glsl.h"

#include <cstdint>
#include <span>
#include <vector>

namespace ajar {

// Where a baked triangle came from.
struct TriangleSource {
    std::uint32_t instance = 0; // Scene::instances; for meshes that stay instanced: any instance of the mesh
    std::uint32_t triangle = 0; // of its mesh
};

// Whether a transform mirrors. An instance's baked triangles then have their second and third vertex swapped,
// so that front faces stay counter-clockwise, and with them their barycentrics.
bool mirrors(const glm::mat4& transform);

// A piece of a placed triangle: the SurfaceElement of someone who knows the Scene alone. Barycentrics are
// weights of the second and third vertex as the mesh has them.
struct SceneElement {
    std::uint32_t instance = 0; // Scene::instances
    std::uint32_t triangle = 0; // of its mesh
    std::uint32_t flags = 0;    // ELEMENT_*
    glm::vec2 origin{0, 0};
    glm::vec2 edge_a{1, 0};
    glm::vec2 edge_b{0, 1};
};

// Of a scene all of whose instances are baked. `scene` must outlive it.
class SurfaceIndex {
  public:
    SurfaceIndex(const Scene& scene, std::span<const TriangleSource> sources);

    // The place in leaf order of a triangle of an instance's mesh.
    std::uint32_t leaf(std::uint32_t instance, std::uint32_t triangle) const {
        return leaves_[first_[instance] + triangle];
    }
    shared::SurfaceElement element(const SceneElement& element) const;

  private:
    const Scene& scene_;
    std::vector<std::size_t> first_; // in leaves_, by instance
    std::vector<std::uint32_t> leaves_;
};

} // namespace ajar
