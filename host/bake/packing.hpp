// Rectangles into a square without overlap, by a skyline (Jylänki 2010, "A thousand ways to pack the bin").
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <vector>

namespace ajar {

// Each rectangle's least corner, or nothing where they do not fit. The highest first, each as low as it
// goes, then as far to the left.
std::optional<std::vector<glm::uvec2>> pack(std::span<const glm::uvec2> sizes, std::uint32_t side);

} // namespace ajar
