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
    // As in a heap of fours: the nodes of a level are those from a power of four up to twice that.
    std::array<VisibilityCount, VISIBILITY_CELL_BYTES> nodes{};
    for (std::uint32_t c = 0; c < VISIBILITY_CLUSTERS; ++c) nodes[VISIBILITY_CLUSTERS + c] = counts[c];
    for (std::uint32_t level = VISIBILITY_CLUSTERS; level > 1; level /= 4)
        for (std::uint32_t k = level; k < 2 * level; ++k) {
            nodes[k / 4].traced += nodes[k].traced;
            nodes[k / 4].arrived += nodes[k].arrived;
        }
    std::array<double, VISIBILITY_CELL_BYTES> shares{};
    std::vector<std::uint8_t> bytes(VISIBILITY_CELL_BYTES, 255); // nodes that there are not: never read
    bytes[0] = to_byte(share(counts[VISIBILITY_CLUSTERS], 1));   // distant lights
    for (std::uint32_t level = 1; level <= VISIBILITY_CLUSTERS; level *= 4)
        for (std::uint32_t k = level; k < 2 * level; ++k) {
            shares[k] = share(nodes[k], k == 1 ? 1 : shares[k / 4]);
            bytes[k] = to_byte(shares[k]);
        }
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
