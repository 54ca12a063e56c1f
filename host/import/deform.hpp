// The shape a file gives before any animation: morph targets at their default weights, skins at the pose of
// the nodes.
#pragma once

#include "import/nodes.hpp"
#include "import/primitives.hpp"

namespace ajar::gltf {

// Adds the weighted displacements to positions, normals and tangents.
void apply_morph_targets(const JsonObject& json, std::span<const float> weights, PrimitiveReader& reader,
                         Primitive& primitive);

// A joint's matrix takes a vertex from the mesh's bind pose to the world.
std::vector<glm::mat4> joint_matrices(const JsonObject& skin, const Nodes& nodes, Accessors& accessors);

// Moves the vertices to world space, each by the weighted mean of its joints' matrices.
void apply_skin(const JsonObject& json, std::span<const glm::mat4> joints, Primitive& primitive);

} // namespace ajar::gltf
