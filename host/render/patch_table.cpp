#include "render/patch_table.hpp"

#include <algorithm>

namespace ajar {

using namespace shared;

namespace {

constexpr std::uint64_t TEXEL_BYTES = sizeof(TableWord);
static_assert(sizeof(PatchNode) == TEXEL_BYTES && sizeof(PatchSide) == PATCH_SIDE_TEXELS * TEXEL_BYTES);

} // namespace

std::vector<std::uint32_t> patch_roots(std::span<const TriangleSource> leaf_order,
                                       std::span<const TriangleSource> divided) {
    const auto before = [](const TriangleSource& a, const TriangleSource& b) {
        return a.instance != b.instance ? a.instance < b.instance : a.triangle < b.triangle;
    };
    std::vector<std::uint32_t> roots;
    roots.reserve(leaf_order.size());
    for (const TriangleSource& triangle : leaf_order) {
        const auto at = std::lower_bound(divided.begin(), divided.end(), triangle, before);
        const bool found = at != divided.end() && !before(triangle, *at);
        roots.push_back(found ? static_cast<std::uint32_t>(at - divided.begin()) : PATCH_NONE);
    }
    return roots;
}

PatchTable::PatchTable(const gpu::Device& device, std::span<const TriangleSource> leaf_order,
                       std::span<const TriangleSource> divided, std::span<const PatchNode> nodes,
                       std::span<const PatchSide> sides) {
    const std::vector<std::uint32_t> roots = patch_roots(leaf_order, divided);
    nodes_first_ =
        static_cast<std::uint32_t>((roots.size() * sizeof(roots[0]) + TEXEL_BYTES - 1) / TEXEL_BYTES);
    sides_first_ = nodes_first_ + static_cast<std::uint32_t>(nodes.size());
    const std::uint64_t bytes = sides_first_ * TEXEL_BYTES + sides.size_bytes();
    table_ = gpu::Buffer(device, std::max(bytes, TEXEL_BYTES), "patches"); // never empty
    if (!roots.empty()) table_.write(std::span<const std::uint32_t>(roots));
    if (!nodes.empty()) table_.write(std::as_bytes(nodes), nodes_first_ * TEXEL_BYTES);
    if (!sides.empty()) table_.write(std::as_bytes(sides), sides_first_ * TEXEL_BYTES);
}

void PatchTable::describe(FrameRecord& frame) const {
    frame.patches.address = table_.address();
    frame.patch_nodes_first = nodes_first_;
    frame.patch_sides_first = sides_first_;
}

bool PatchTable::fits_texel_buffer(const gpu::Device& device) const {
    return gpu::Bindings::table_fits(device, BIND_PATCHES, table_.size_bytes());
}

} // namespace ajar
