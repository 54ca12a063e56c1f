#include "render/learned_visibility.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <tbb/parallel_for.h>

namespace ajar {

using namespace shared;

namespace {

// Rays that a node's prior, its parent's share, counts for.
constexpr double PRIOR_RAYS = 1;
constexpr std::uint8_t LEAST = 3; // 1/64: see freeze_cell

double share(const VisibilityCount& count, double prior) {
    return (count.arrived + PRIOR_RAYS * prior) / (count.traced + PRIOR_RAYS);
}

std::uint8_t to_byte(double visibility) {
    const double byte = std::round(visibility * 256) - 1;
    return static_cast<std::uint8_t>(std::clamp(byte, double{LEAST}, 255.0));
}

} // namespace

std::vector<std::uint8_t> freeze_cell(std::span<const VisibilityCount> counts) {
    std::array<VisibilityCount, 2 * VISIBILITY_CLUSTERS> nodes{}; // as in a heap
    for (std::uint32_t c = 0; c < VISIBILITY_CLUSTERS; ++c) nodes[VISIBILITY_CLUSTERS + c] = counts[c];
    for (std::uint32_t k = VISIBILITY_CLUSTERS - 1; k > 0; --k) {
        nodes[k].traced = nodes[2 * k].traced + nodes[2 * k + 1].traced;
        nodes[k].arrived = nodes[2 * k].arrived + nodes[2 * k + 1].arrived;
    }
    std::array<double, 2 * VISIBILITY_CLUSTERS> shares{};
    std::vector<std::uint8_t> bytes(VISIBILITY_CELL_BYTES);
    bytes[0] = to_byte(share(counts[VISIBILITY_CLUSTERS], 1)); // distant lights
    shares[1] = share(nodes[1], 1);
    for (std::uint32_t k = 2; k < nodes.size(); ++k) shares[k] = share(nodes[k], shares[k / 2]);
    for (std::uint32_t k = 1; k < nodes.size(); ++k) bytes[k] = to_byte(shares[k]);
    return bytes;
}

LearnedVisibility::LearnedVisibility(const gpu::Device& device)
    : counts_(device, std::uint64_t{VISIBILITY_CELLS} * VISIBILITY_COUNTERS * sizeof(VisibilityCount),
              "visibility counts"),
      table_(device, std::uint64_t{VISIBILITY_CELLS} * VISIBILITY_CELL_BYTES, "learned visibility") {}

void LearnedVisibility::freeze() {
    const std::vector<VisibilityCount> counts =
        counts_.read<VisibilityCount>(0, std::uint64_t{VISIBILITY_CELLS} * VISIBILITY_COUNTERS);
    std::vector<std::uint8_t> table(std::size_t{VISIBILITY_CELLS} * VISIBILITY_CELL_BYTES);
    tbb::parallel_for(std::size_t(0), std::size_t{VISIBILITY_CELLS}, [&](std::size_t cell) {
        const std::vector<std::uint8_t> bytes =
            freeze_cell(std::span(counts).subspan(cell * VISIBILITY_COUNTERS, VISIBILITY_COUNTERS));
        std::copy(bytes.begin(), bytes.end(),
                  table.begin() + static_cast<std::ptrdiff_t>(cell * VISIBILITY_CELL_BYTES));
    });
    table_.write(std::span<const std::uint8_t>(table));
    counts_ = gpu::Buffer();
    frozen_ = true;
}

void LearnedVisibility::describe(FrameRecord& frame) const {
    frame.visibility.address = table_.address();
    frame.visibility_counts.address = counts_.address();
}

bool LearnedVisibility::fits_texel_buffer(const gpu::Device& device) const {
    return gpu::Bindings::table_fits(device, BIND_VISIBILITY, table_.size_bytes());
}

} // namespace ajar
