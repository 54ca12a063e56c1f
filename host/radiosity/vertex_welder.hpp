// Vertices by their positions: equal bits are one vertex.
#pragma once

#include "radiosity/index_table.hpp"

#include <bit>
#include <glm/glm.hpp>
#include <vector>

namespace ajar {

class VertexWelder {
  public:
    // Appends to `positions`, which must outlive this and begin empty or hold each position once.
    explicit VertexWelder(std::vector<glm::vec3>& positions) : positions_(positions) {
        const std::vector<glm::vec3> old = std::move(positions_);
        positions_.clear();
        positions_.reserve(old.size());
        for (const glm::vec3& p : old) vertex(p);
    }

    std::uint32_t vertex(const glm::vec3& position) {
        const glm::vec3 p = position + 0.0f; // one zero
        return table_.find_or_make(
            hash(p), [&](std::uint32_t v) { return positions_[v] == p; },
            [&] {
                positions_.push_back(p);
                return static_cast<std::uint32_t>(positions_.size() - 1);
            },
            [&](std::uint32_t v) { return hash(positions_[v]); });
    }

  private:
    static std::uint64_t hash(const glm::vec3& p) {
        const std::uint64_t xy =
            std::uint64_t{std::bit_cast<std::uint32_t>(p.x)} << 32 | std::bit_cast<std::uint32_t>(p.y);
        return IndexTable::mix(IndexTable::mix(xy) + std::bit_cast<std::uint32_t>(p.z));
    }

    std::vector<glm::vec3>& positions_;
    IndexTable table_;
};

} // namespace ajar
