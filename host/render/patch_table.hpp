// Patches on the device (shared/patch.glsl.h): which one a hit lies in, and, where a picture is made of them,
// what their sides look like.
#pragma once

#include "gpu/bindings.hpp"
#include "render/surface_index.hpp"
#include "shaders/shared/bindings.glsl.h"
#include "shaders/shared/frame.glsl.h"
#include "shaders/shared/patch.glsl.h"

#include <cstdint>
#include <span>
#include <vector>

namespace ajar {

// For each triangle of a scene in leaf order the place among `divided`, which must be sorted by instance and
// triangle, or PATCH_NONE.
std::vector<std::uint32_t> patch_roots(std::span<const TriangleSource> leaf_order,
                                       std::span<const TriangleSource> divided);

class PatchTable {
  public:
    // `divided`: the triangles that have patches, sorted; the first nodes are the roots of their trees, in
    // the same order. `sides`: two for each patch, or none.
    PatchTable(const gpu::Device& device, std::span<const TriangleSource> leaf_order,
               std::span<const TriangleSource> divided, std::span<const shared::PatchNode> nodes,
               std::span<const shared::PatchSide> sides = {});

    void bind(gpu::Bindings& bindings) const { bindings.table(shared::BIND_PATCHES, table_); }
    void describe(shared::FrameRecord& frame) const;
    // Whether it can be a texel buffer; if not, all tables are read through pointers.
    bool fits_texel_buffer(const gpu::Device& device) const;
    std::uint64_t device_bytes() const { return table_.size_bytes(); }

  private:
    std::uint32_t nodes_first_ = 0; // texels
    std::uint32_t sides_first_ = 0;
    gpu::Buffer table_;
};

} // namespace ajar
