// Light in the colours of vertices: the patches' mesh, unlit, with the textures it had.
#pragma once

#include "bake/brightness.hpp"
#include "bake/element_light.hpp"
#include "radiosity/patch_mesh.hpp"

namespace ajar {

// The fronts of the patches as elements.
std::vector<SceneElement> patch_elements(const Scene& scene, const PatchMesh& mesh);

// `light` by patch. Everything is in the world, an instance for each of the scene's; cameras
// stay, lights go.
Scene vertex_colored_scene(const Scene& scene, const PatchMesh& mesh, const ElementLight& light,
                           float exposure, Brightness& brightness);

} // namespace ajar
