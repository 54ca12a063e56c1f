// Accessors: typed arrays out of buffer views, with normalisation, strides and sparse substitution
// (glTF 2.0, sections 3.6.2 and 3.11). Every range is checked before anything is allocated.
#pragma once

#include "import/buffers.hpp"

namespace ajar::gltf {

// Which elements to read; empty means all of them, in order.
using Selection = std::span<const std::uint32_t>;

class Accessors {
  public:
    Accessors(Document& document, Buffers& buffers);

    std::size_t count() const { return accessors_.size(); }
    std::uint64_t elements(std::uint32_t accessor) const;
    unsigned components(std::uint32_t accessor) const; // 1 SCALAR, 2 .. 4 VECn, 16 MAT4
    bool normalized(std::uint32_t accessor) const;
    const JsonObject& object(std::uint32_t accessor) const { return accessors_[accessor]; }

    // T: float, glm::vec2, vec3, vec4 or mat4; the accessor must have as many components. `selection` must be
    // in range.
    template <class T> std::vector<T> read(std::uint32_t accessor, Selection selection = {});

    // Unsigned integers as they are: vertex indices (std::uint32_t) and joints (glm::uvec4).
    template <class T> std::vector<T> read_integers(std::uint32_t accessor, Selection selection = {});

  private:
    template <class Scalar, class T> std::vector<T> read_as(std::uint32_t accessor, Selection selection);
    template <class Scalar>
    void read_dense(std::uint32_t accessor, Selection selection, std::span<Scalar> out);
    template <class Scalar>
    void apply_sparse(std::uint32_t accessor, const JsonObject& sparse, std::span<Scalar> out);

    Document& document_;
    Buffers& buffers_;
    std::vector<JsonObject> accessors_;
};

} // namespace ajar::gltf
