// What is placed in the scene: meshes, lights, cameras.
#pragma once

#include "export/document.hpp"

#include <vector>

namespace ajar::gltf_out {

// `meshes`: of add_meshes().
void add_instances(const Scene& scene, const std::vector<std::uint32_t>& meshes, Document& document);
void add_lights(const Scene& scene, Document& document); // KHR_lights_punctual
void add_cameras(const Scene& scene, Document& document);

} // namespace ajar::gltf_out
