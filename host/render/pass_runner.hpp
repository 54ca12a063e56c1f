// Runs a pass's steps in slices, so that no submission keeps a slow device busy for seconds (watchdogs kill
// those). How it slices depends on measured times, but never changes the image: segments do not know of each
// other.
#pragma once

#include "gpu/commands.hpp"
#include "render/integrator.hpp"

#include <cstdint>
#include <functional>
#include <vector>

namespace ajar {

class PassRunner {
  public:
    PassRunner(gpu::Commands& commands, const std::vector<Step>& steps, double slice_seconds);

    // All steps over all segments of the pass (args.segment_count of them, from 0). `keep_going` is asked
    // between submissions; false abandons the pass and is returned.
    bool run(const shared::SegmentArgs& args, const std::function<bool()>& keep_going);

  private:
    void adapt(double seconds, std::size_t steps_done, std::uint32_t segments_done);

    gpu::Commands& commands_;
    const std::vector<Step>& steps_;
    double slice_seconds_;
    std::size_t steps_per_submit_;
    std::uint32_t segments_per_slice_ = UINT32_MAX;
};

} // namespace ajar
