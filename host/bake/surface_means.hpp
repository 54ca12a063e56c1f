// What pieces of surface are made of.
#pragma once

#include "render/surface_index.hpp"
#include "scene/scene.hpp"

#include <span>
#include <vector>

namespace ajar {

// Means over a piece, linear. Where they are of a texture and its factors, of both.
struct SurfaceMean {
    glm::vec3 texture{1, 1, 1};     // of the base colour's texture alone
    glm::vec3 reflectance{0, 0, 0}; // of diffuse light from all around, the share that is reflected
    glm::vec3 emission{0, 0, 0};    // radiance sent without any light; of unlit materials what they show
    float alpha = 1;                // before any cutoff
};

std::vector<SurfaceMean> surface_means(const Scene& scene, std::span<const SceneElement> elements);

// Of the materials on the scene's triangles, those that reflect otherwise than by Lambert's law, by name.
std::vector<std::string> view_dependent_materials(const Scene& scene);

} // namespace ajar
