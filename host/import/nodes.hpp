// The node tree (glTF 2.0, section 3.5): world transforms, and which nodes the chosen scene holds.
#pragma once

#include "import/document.hpp"

namespace ajar::gltf {

class Nodes {
  public:
    // Reads every node, rejects nodes with two parents and cycles, chooses the scene (ImportOptions::scene).
    explicit Nodes(Document& document);

    std::size_t count() const { return objects_.size(); }
    const JsonObject& object(std::uint32_t node) const { return objects_[node]; }
    const glm::mat4& to_world(std::uint32_t node) const { return to_world_[node]; }

    // The chosen scene's nodes, parents before children, in the file's order.
    const std::vector<std::uint32_t>& in_scene() const { return in_scene_; }
    std::string scene_name() const;

    // The node's name, or "node 7".
    std::string name(std::uint32_t node) const;

  private:
    void link();
    void place(Document& document);
    std::vector<std::uint32_t> choose_scene(Document& document);
    void collect(const std::vector<std::uint32_t>& roots);

    std::vector<JsonObject> objects_;
    std::vector<std::vector<std::uint32_t>> children_;
    std::vector<std::uint32_t> parents_; // NO_INDEX for roots
    std::vector<glm::mat4> to_world_;
    std::vector<std::uint32_t> in_scene_;
    std::string scene_name_;
};

} // namespace ajar::gltf
