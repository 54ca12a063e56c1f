// Light in a texture: the scene's meshes on their atlas, unlit.
#pragma once

#include "bake/brightness.hpp"
#include "bake/element_light.hpp"
#include "bake/texels.hpp"
#include "image/image.hpp"

namespace ajar {

// What texels show, as elements; by texel as `covered` is.
std::vector<SceneElement> texel_elements(const Atlas& atlas, std::span<const CoveredTexel> covered);

// The scene with a mesh for each instance whose second texture coordinates are the atlas'. Triangles without
// area are gone; everything else is as it was.
Scene unwrapped_scene(const Scene& scene, const Atlas& atlas);

// The same for materials that keep their textures. Those that use the second set alone get it as their first;
// those that use both keep both, have no place in the atlas, and are named in `without`.
Scene unwrapped_scene_with_textures(const Scene& scene, const Atlas& atlas,
                                    std::vector<std::string>& without);

// `unwrapped` unlit, with everything that is seen in one texture: reflected light, textures, emission.
// Cameras stay, lights go. `light` by covered texel.
Scene lightmapped_scene(Scene unwrapped, std::uint32_t side, std::span<const CoveredTexel> covered,
                        const ElementLight& light, float exposure, Brightness& brightness);

// W/m^2 by texel, gutter filled; R, G, B, and A = 1.
Image irradiance_image(std::uint32_t side, std::span<const CoveredTexel> covered,
                       std::span<const glm::vec3> irradiance);

// `unwrapped`, with textures, with the share of sky that is open as its occlusion textures. `openness` by
// covered texel.
Scene occluded_scene(Scene unwrapped, std::uint32_t side, std::span<const CoveredTexel> covered,
                     std::span<const glm::vec3> openness);

} // namespace ajar
