// KHR_draco_mesh_compression: a primitive's indices and attributes in one Draco stream.
#pragma once

#include "import/buffers.hpp"

#include <memory>

namespace ajar::gltf {

class DracoPrimitive {
  public:
    // Decodes the stream. Throws Error when it is damaged or is no triangle mesh.
    DracoPrimitive(const JsonObject& extension, Document& document, Buffers& buffers);
    ~DracoPrimitive();

    std::uint64_t vertex_count() const;
    std::vector<std::uint32_t> indices() const; // three per triangle
    bool has(std::string_view attribute) const;

    // All vertices, out.size() / vertex_count() components each. Integers are divided by their type's maximum
    // where `normalized`, as the accessor that stands for the attribute says.
    void read(std::string_view attribute, bool normalized, std::span<float> out) const;

  private:
    struct Decoded;
    JsonObject extension_;
    std::unique_ptr<Decoded> decoded_;
};

} // namespace ajar::gltf
