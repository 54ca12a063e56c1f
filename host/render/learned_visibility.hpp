// What the light sampler `visibility` knows: for cells of surface points, the share of shadow rays that
// arrived from each node of the light tree's first levels. Learned in a pass of its own from a fixed number
// of samples, by integer sums, then frozen: no sample of the image depends on which others were taken.
#pragma once

#include "gpu/bindings.hpp"
#include "shaders/shared/bindings.glsl.h"
#include "shaders/shared/frame.glsl.h"
#include "shaders/shared/light_visibility.glsl.h"

#include <cstdint>
#include <span>
#include <vector>

namespace ajar {

class LearnedVisibility {
  public:
    explicit LearnedVisibility(const gpu::Device& device);

    bool is_frozen() const { return frozen_; }
    // Counts become shares; done once.
    void freeze();
    void bind(gpu::Bindings& bindings) const { bindings.table(shared::BIND_VISIBILITY, table_); }
    void describe(shared::FrameRecord& frame) const;
    // Whether its table can be a texel buffer; if not, all tables are read through pointers.
    bool fits_texel_buffer(const gpu::Device& device) const;
    std::uint64_t device_bytes() const { return counts_.size_bytes() + table_.size_bytes(); }

    double seconds = 0; // that learning took

  private:
    gpu::Buffer counts_; // VisibilityCount[cells * VISIBILITY_COUNTERS]; empty once frozen
    gpu::Buffer table_;  // VISIBILITY_CELL_BYTES for each cell
    bool frozen_ = false;
};

// Shares of one cell from its VISIBILITY_COUNTERS counts, as light_visibility.glsl.h lays them out: those of
// a node with few rays lean towards its parent's, and none is below 1/64, so that a light seen by no ray of
// the pass keeps its chance.
std::vector<std::uint8_t> freeze_cell(std::span<const shared::VisibilityCount> counts);

} // namespace ajar
