#include "render/octahedral.hpp"

#include <cmath>

namespace ajar {

std::uint32_t octahedral_encode(const glm::vec3& n) {
    const float norm = std::abs(n.x) + std::abs(n.y) + std::abs(n.z);
    if (!(norm > 0)) return 0;
    glm::vec2 p = glm::vec2(n) / norm;
    if (n.z < 0)
        p = {(1 - std::abs(p.y)) * (p.x < 0 ? -1.0f : 1.0f), (1 - std::abs(p.x)) * (p.y < 0 ? -1.0f : 1.0f)};
    const auto snorm = [](float x) {
        return static_cast<std::uint32_t>(
            static_cast<std::uint16_t>(static_cast<std::int16_t>(std::lround(x * 32767))));
    };
    return snorm(p.x) | snorm(p.y) << 16;
}

} // namespace ajar
