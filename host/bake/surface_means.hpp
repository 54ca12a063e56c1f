// What of a piece of surface is known on the host alone: the textures of its base colour.
#pragma once

#include "render/surface_index.hpp"
#include "scene/scene.hpp"

#include <span>
#include <string>
#include <vector>

namespace ajar {

// Means over a piece.
struct TextureMean {
    glm::vec3 color{1, 1, 1}; // of the base colour's texture alone, linear
    float alpha = 1;          // of texture, factor and vertices, before any cutoff
};

std::vector<TextureMean> texture_means(const Scene& scene, std::span<const SceneElement> elements);

// A point of a piece, (0, 0) to (1, 1), as barycentrics. Where the piece reaches beyond its triangle, on the
// triangle's border, as paths begin there (shaders/geometry/element.glsl).
glm::vec2 point_on(const SceneElement& element, glm::vec2 w);

// Of the materials on the scene's triangles, those that reflect otherwise than by Lambert's law, by name.
std::vector<std::string> view_dependent_materials(const Scene& scene);

} // namespace ajar
