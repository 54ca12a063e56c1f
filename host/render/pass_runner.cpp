#include "render/pass_runner.hpp"

#include "render/path_pool.hpp"

#include <algorithm>

namespace ajar {

PassRunner::PassRunner(gpu::Commands& commands, const std::vector<Step>& steps, double slice_seconds)
    : commands_(commands), steps_(steps), slice_seconds_(slice_seconds), steps_per_submit_(1) {}

bool PassRunner::run(const shared::SegmentArgs& args, const std::function<bool()>& keep_going) {
    std::uint32_t first = 0;
    while (first < args.segment_count) {
        shared::SegmentArgs slice = args;
        slice.first_segment = first;
        slice.segment_count = std::min(segments_per_slice_, args.segment_count - first);
        slice.segment_stride = PathPool::interleaving_stride(slice.segment_count);
        for (std::size_t step = 0; step < steps_.size();) {
            const std::size_t end = std::min(step + steps_per_submit_, steps_.size());
            const std::size_t count = end - step;
            for (; step < end; ++step) steps_[step](commands_, slice);
            const double seconds = commands_.submit();
            if (!keep_going()) return false;
            adapt(seconds, count, slice.segment_count);
        }
        first += slice.segment_count;
    }
    return true;
}

// Fewer steps in a submission before fewer segments: small slices leave a wide device idle.
void PassRunner::adapt(double seconds, std::size_t steps_done, std::uint32_t segments_done) {
    if (seconds > 2 * slice_seconds_) {
        if (steps_per_submit_ > 1)
            steps_per_submit_ = std::max<std::size_t>(steps_done / 2, 1);
        else
            segments_per_slice_ = std::max(segments_done / 2, 1u);
    } else if (seconds < 0.5 * slice_seconds_) {
        if (steps_per_submit_ < steps_.size())
            steps_per_submit_ *= 2;
        else if (segments_per_slice_ < UINT32_MAX / 2)
            segments_per_slice_ *= 2;
    }
}

} // namespace ajar
