// Meshes: a glTF mesh becomes one Mesh with the triangles of all its primitives; a skinned or morphed node
// gets its own.
#pragma once

#include "import/deform.hpp"
#include "import/nodes.hpp"
#include "import/sphere_lights.hpp"

#include <map>
#include <tuple>

namespace ajar::gltf {

// The glTF meshes that nodes of the chosen scene show.
std::vector<bool> meshes_in_scene(const Document& document, const Nodes& nodes);

// Which materials the triangles of those meshes have.
std::vector<bool> materials_in_scene(Document& document, const std::vector<bool>& meshes);

class Meshes {
  public:
    // scene.materials must be complete.
    Meshes(Document& document, Buffers& buffers, Accessors& accessors, const Nodes& nodes, Scene& scene);

    // Appends an instance for the node's mesh; nothing where that has no triangles.
    void add_instance(std::uint32_t node);

  private:
    // The glTF mesh, the skin (or NO_INDEX) and the morph weights decide the shape.
    using Shape = std::tuple<std::uint32_t, std::uint32_t, std::vector<float>>;

    std::uint32_t mesh_of(const Shape& shape);
    void add_primitive(const JsonObject& json, const Shape& shape, std::span<const glm::mat4> joints,
                       Mesh& mesh);
    std::uint32_t material_of(const JsonObject& primitive);

    Document& document_;
    Accessors& accessors_;
    const Nodes& nodes_;
    Scene& scene_;
    PrimitiveReader reader_;
    std::vector<JsonObject> meshes_;
    std::vector<JsonObject> skins_;
    std::map<Shape, std::uint32_t> shapes_; // index into Scene::meshes, NO_INDEX: without triangles
    SphereLights sphere_lights_;
    std::uint32_t default_material_ = NO_INDEX;
    std::size_t file_materials_;
};

} // namespace ajar::gltf
