// Light in the colours of vertices: the patches' mesh, unlit, with the textures it had.
#pragma once

#include "bake/brightness.hpp"
#include "bake/surface_means.hpp"
#include "radiosity/patch_mesh.hpp"

namespace ajar {

// The fronts of the patches as elements.
std::vector<SceneElement> patch_elements(const Scene& scene, const PatchMesh& mesh);

// `irradiance` and `means` by patch. Everything is in the world, an instance for each of the scene's; cameras
// stay, lights go.
Scene vertex_colored_scene(const Scene& scene, const PatchMesh& mesh, std::span<const glm::vec3> irradiance,
                           std::span<const SurfaceMean> means, float exposure, Brightness& brightness);

} // namespace ajar
