// Materials, and the textures and images they use.
#pragma once

#include "export/document.hpp"

namespace ajar::gltf_out {

// Indices in the file are those of the scene.
void add_materials(const Scene& scene, Document& document);
void add_textures(const Scene& scene, Document& document);

// A colour without bound as one in [0, 1] and a factor. The factor is a power of two, so that the product is
// the very colour.
struct ScaledColor {
    glm::vec3 color;
    float factor; // at least 1
};
ScaledColor scaled_color(const glm::vec3& color);

} // namespace ajar::gltf_out
