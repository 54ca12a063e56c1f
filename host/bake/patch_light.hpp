// Light by radiosity: solved for on patches, and looked up where it is wanted.
#pragma once

#include "bake/element_light.hpp"
#include "bake/settings.hpp"
#include "radiosity/radiosity.hpp"

namespace ajar {

RadiositySolution solve_for_bake(const gpu::Device& device, const Scene& scene, const BakeSettings& settings,
                                 const ProgressSink& progress, const WarningSink& warn);

// Of the patches' fronts, by patch.
std::vector<glm::vec3> front_irradiance(const RadiositySolution& solution);
ElementMaterials front_materials(const RadiositySolution& solution);

// At the middles of elements, interpolated between the patches' corners.
std::vector<glm::vec3> irradiance_at(const Scene& scene, const RadiositySolution& solution,
                                     std::span<const SceneElement> elements);

} // namespace ajar
