#include "radiosity/form_factors.hpp"

#include "shaders/shared/radiosity.glsl.h"
#include "shaders/shared/specialization.glsl.h"

#include <algorithm>
#include <bit>

namespace ajar {

using namespace shared;

namespace {

constexpr std::uint64_t CHUNK_BYTES = 64u << 20;

gpu::Specialization with_option(gpu::Specialization specialization, std::uint32_t option) {
    specialization.emplace_back(SPEC_OPTION, option);
    return specialization;
}

} // namespace

FormFactors::FormFactors(RadiosityRig& rig, std::uint32_t rays, std::uint64_t memory_bytes)
    : rig_(rig), rays_log2_(static_cast<std::uint32_t>(std::countr_zero(rays))),
      row_side_buffer_(rig.device, rig.side_count() * sizeof(SideIndex), "sides of rows"),
      met_(rig.device, (rig.side_count() + SIDES_BESIDE) * sizeof(SideIndex), "sides met"),
      totals_(rig.device, sizeof(RowTotals), "totals of rows"),
      radiate_(rig.device, "radiate", rig.specialization),
      extend_(rig.device, "extend", with_option(rig.specialization, EXTEND_BOUNCE)),
      tally_(rig.device, "tally", rig.specialization), receive_(rig.device, "receive", rig.plain()),
      steps_(rig.trace_shares), runner_(rig.commands, steps_.list(), rig.settings.slice_seconds) {
    const std::uint64_t row_bytes = std::uint64_t{rays} * sizeof(SideIndex);
    max_stored_rows_ =
        static_cast<std::uint32_t>(std::min<std::uint64_t>(memory_bytes / row_bytes, rig.side_count()));
    rows_in_chunk_ = static_cast<std::uint32_t>(
        std::clamp<std::uint64_t>(CHUNK_BYTES / row_bytes, 1, std::max(max_stored_rows_, 1u)));
    add_steps();
}

void FormFactors::add_steps() {
    steps_.add([this](gpu::Commands& commands, const SegmentArgs& slice) {
        const RadiateArgs args{{rig_.element_buffer.address()}, {row_side_buffer_.address()}, slice, 0};
        radiate_.dispatch(commands, args, slice.segment_count);
    });
    steps_.add(extend_, 0);
    steps_.add([this](gpu::Commands& commands, const SegmentArgs& slice) {
        const TallyArgs args{{target_.address}, {met_.address()}, {totals_.address()}, slice,
                             target_.first_row, rays_log2_,       rig_.side_count()};
        tally_.dispatch(commands, args, slice.segment_count);
    });
}

// Rows that a pass holds; one where it holds a part of one.
std::uint32_t FormFactors::rows_at_once() const { return std::max(rig_.pool.paths() >> rays_log2_, 1u); }

bool FormFactors::trace_rows(Target target, std::uint32_t first, std::uint32_t count,
                             const KeepGoing& keep_going) {
    target_ = target;
    const std::uint32_t rays_at_once = std::min(rays(), std::bit_floor(rig_.pool.paths()));
    for (std::uint32_t row = first; row < first + count; row += rows_at_once())
        for (std::uint32_t ray = 0; ray < rays(); ray += rays_at_once) {
            SegmentArgs args{};
            args.path_count = std::min(rows_at_once(), first + count - row) * rays_at_once;
            args.segment_count =
                (args.path_count + rig_.pool.segment_paths() - 1) / rig_.pool.segment_paths();
            args.first_ordinal = row;
            args.samples_log2 = static_cast<std::uint32_t>(std::countr_zero(rays_at_once));
            args.first_sample = ray;
            if (!runner_.run(args, keep_going)) return false;
        }
    return true;
}

void FormFactors::append_rows(std::span<const std::uint32_t> sides) {
    row_sides_.insert(row_sides_.end(), sides.begin(), sides.end());
    row_side_buffer_.write(std::span<const std::uint32_t>(row_sides_));
    stored_rows_ = std::min(row_count(), max_stored_rows_);
    while (chunks_.size() * rows_in_chunk_ < stored_rows_) {
        const std::uint64_t before = chunks_.size() * rows_in_chunk_;
        const std::uint64_t rows = std::min<std::uint64_t>(rows_in_chunk_, max_stored_rows_ - before);
        chunks_.emplace_back(rig_.device, rows * rays() * sizeof(SideIndex), "rows of form factors");
    }
    if (stored_rows_ < row_count() && !scratch_)
        scratch_ = gpu::Buffer(rig_.device, std::uint64_t{rows_at_once()} * rays() * sizeof(SideIndex),
                               "rows under way");
}

bool FormFactors::trace(std::span<const std::uint32_t> sides, const Traced& progress) {
    std::vector<std::uint8_t> has_row(rig_.side_count());
    std::vector<std::uint32_t> fresh(sides.begin(), sides.end());
    while (!fresh.empty()) {
        std::uint32_t row = row_count();
        append_rows(fresh);
        for (const std::uint32_t side : fresh) has_row[side] = 1;
        while (row < row_count()) {
            const bool stored = row < stored_rows_;
            const std::uint32_t chunk = row / rows_in_chunk_;
            const std::uint32_t end =
                stored ? std::min((chunk + 1) * rows_in_chunk_, stored_rows_) : row_count();
            const std::uint32_t count = std::min(end - row, rows_at_once());
            const Target target = stored ? Target{chunks_[chunk].address(), chunk * rows_in_chunk_}
                                         : Target{scratch_.address(), row};
            const KeepGoing keep_going = [&] { return progress(row, row_count()); };
            if (!trace_rows(target, row, count, keep_going)) {
                row_sides_.clear();
                stored_rows_ = 0;
                return false;
            }
            row += count;
        }
        fresh.clear();
        const std::vector<std::uint32_t> met = met_.read<std::uint32_t>(0, rig_.side_count());
        for (std::uint32_t side = 0; side < met.size(); ++side)
            if (met[side] != 0 && has_row[side] == 0) fresh.push_back(side);
    }
    read_totals();
    progress(row_count(), row_count()); // whoever wants to stop is asked again before long
    return true;
}

void FormFactors::read_totals() {
    const RowTotals totals = totals_.read<RowTotals>(0, 1).front();
    const auto number = [](const uint(&words)[2]) {
        return static_cast<double>(words[0] | std::uint64_t{words[1]} << 32);
    };
    const double all = static_cast<double>(row_count()) * rays();
    if (all > 0) sky_share_ = number(totals.rays_sky) / all;
    if (all > 0) nowhere_share_ = number(totals.rays_nowhere) / all;
}

void FormFactors::record_receive(const gpu::Buffer& from, const gpu::Buffer& to, std::uint64_t rows_address,
                                 std::uint32_t first, std::uint32_t count) {
    const ReceiveArgs args{{rows_address},
                           {row_side_buffer_.address()},
                           {from.address()},
                           {to.address()},
                           first,
                           count,
                           rays_log2_,
                           0};
    receive_.dispatch(rig_.commands, args, rig_.groups(count));
}

bool FormFactors::receive(const gpu::Buffer& from, const gpu::Buffer& to, std::uint32_t first,
                          std::uint32_t count, const KeepGoing& keep_going) {
    std::uint32_t row = first;
    const std::uint32_t end = first + count;
    while (row < std::min(end, stored_rows_)) {
        const std::uint32_t chunk = row / rows_in_chunk_;
        const std::uint32_t stop = std::min({(chunk + 1) * rows_in_chunk_, stored_rows_, end});
        const std::uint64_t skipped =
            std::uint64_t{row - chunk * rows_in_chunk_} * rays() * sizeof(SideIndex);
        record_receive(from, to, chunks_[chunk].address() + skipped, row, stop - row);
        row = stop;
    }
    while (row < end) {
        const std::uint32_t batch = std::min(end - row, rows_at_once());
        if (!trace_rows({scratch_.address(), row}, row, batch, keep_going)) return false;
        record_receive(from, to, scratch_.address(), row, batch);
        row += batch;
    }
    return true;
}

std::vector<std::uint32_t> FormFactors::entries(std::uint32_t row) {
    if (row < stored_rows_) {
        const std::uint32_t chunk = row / rows_in_chunk_;
        const std::uint64_t first = std::uint64_t{row - chunk * rows_in_chunk_} * rays();
        return chunks_[chunk].read<std::uint32_t>(first, rays());
    }
    trace_rows({scratch_.address(), row}, row, 1, [] { return true; });
    return scratch_.read<std::uint32_t>(0, rays());
}

std::uint64_t FormFactors::device_bytes() const {
    std::uint64_t bytes = scratch_.size_bytes() + row_side_buffer_.size_bytes() + met_.size_bytes();
    for (const gpu::Buffer& chunk : chunks_) bytes += chunk.size_bytes();
    return bytes;
}

} // namespace ajar
