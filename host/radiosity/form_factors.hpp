// The rows of F: for each side of a patch, which sides its rays meet (shaders/kernels/radiate.glsl.h). Rows
// are stored as far as memory allows; the others are traced again whenever they are multiplied, by the same
// kernels with the same random numbers, so that no result depends on it.
#pragma once

#include "radiosity/radiosity_rig.hpp"
#include "render/pass_runner.hpp"
#include "shaders/kernels/radiate.glsl.h"
#include "shaders/kernels/receive.glsl.h"
#include "shaders/kernels/tally.glsl.h"

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace ajar {

class FormFactors {
  public:
    using KeepGoing = std::function<bool()>;
    // Rows traced, of those known to be needed; false: stop.
    using Traced = std::function<bool(std::uint32_t done, std::uint32_t total)>;

    // `rays` of a row: a power of two, 4 to 65536.
    FormFactors(RadiosityRig& rig, std::uint32_t rays, std::uint64_t memory_bytes);

    // Rows of these sides, of all sides that their rays meet, and so on. False when stopped: then there are
    // no rows.
    bool trace(std::span<const std::uint32_t> sides, const Traced& progress);

    std::uint32_t row_count() const { return static_cast<std::uint32_t>(row_sides_.size()); }
    const std::vector<std::uint32_t>& row_sides() const { return row_sides_; } // by row
    const gpu::Buffer& row_side_buffer() const { return row_side_buffer_; }

    // Records to = F from for rows [first, first + count), for the rig's commands, to which `from` is bound;
    // only what is stored is recorded alone: to trace the others commands are submitted, and keep_going is
    // asked (false: stopped, and returned). Vectors have side_count + SIDES_BESIDE values.
    bool receive(const gpu::Buffer& from, const gpu::Buffer& to, std::uint32_t first, std::uint32_t count,
                 const KeepGoing& keep_going);

    // A row's entries, as they are traced or stored.
    std::vector<std::uint32_t> entries(std::uint32_t row);

    std::uint32_t rays() const { return 1u << rays_log2_; }
    std::uint32_t stored_rows() const { return stored_rows_; }
    std::uint64_t row_bytes() const { return std::uint64_t{stored_rows_} * rays() * sizeof(std::uint32_t); }
    std::uint64_t device_bytes() const;
    std::uint64_t rays_traced() const { return rig_.pool.totals().extension_rays; }
    std::uint64_t exhausted_loops() const { return rig_.pool.totals().exhausted_loops; }
    // Of the rays of all rows, once each.
    double sky_share() const { return sky_share_; }
    double nowhere_share() const { return nowhere_share_; }

  private:
    // Where entries are written: rows from first_row on.
    struct Target {
        std::uint64_t address = 0;
        std::uint32_t first_row = 0;
    };

    void append_rows(std::span<const std::uint32_t> sides);
    bool trace_rows(Target target, std::uint32_t first, std::uint32_t count, const KeepGoing& keep_going);
    std::uint32_t rows_at_once() const;
    void record_receive(const gpu::Buffer& from, const gpu::Buffer& to, std::uint64_t rows_address,
                        std::uint32_t first, std::uint32_t count);
    void add_steps();
    void read_totals();

    RadiosityRig& rig_;
    std::uint32_t rays_log2_;
    std::uint32_t rows_in_chunk_;
    std::uint32_t max_stored_rows_;
    std::uint32_t stored_rows_ = 0;
    std::vector<std::uint32_t> row_sides_;
    std::vector<gpu::Buffer> chunks_; // chunk c: rows [c, c + 1) * rows_in_chunk_
    gpu::Buffer scratch_;             // of rows that are not stored
    gpu::Buffer row_side_buffer_;
    gpu::Buffer met_; // by side
    gpu::Buffer totals_;
    double sky_share_ = 0;
    double nowhere_share_ = 0;
    gpu::Kernel<shared::RadiateArgs> radiate_;
    gpu::Kernel<shared::ExtendArgs> extend_;
    gpu::Kernel<shared::TallyArgs> tally_;
    gpu::Kernel<shared::ReceiveArgs> receive_;
    Target target_; // of the pass under way
    Steps steps_;
    PassRunner runner_;
};

} // namespace ajar
