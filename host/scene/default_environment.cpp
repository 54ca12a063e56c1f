#include "scene/default_environment.hpp"

#include <cmath>
#include <glm/gtc/constants.hpp>

namespace ajar {

Environment default_environment() {
    Environment environment;
    environment.name = "default studio";
    environment.width = 64;
    environment.height = 32;
    const glm::vec3 key = glm::normalize(glm::vec3(-0.6f, 0.7f, 0.6f));
    for (std::uint32_t row = 0; row < environment.height; ++row)
        for (std::uint32_t column = 0; column < environment.width; ++column) {
            const float theta = (static_cast<float>(row) + 0.5f) / 32.0f * glm::pi<float>();
            const float phi = ((static_cast<float>(column) + 0.5f) / 64.0f - 0.5f) * glm::two_pi<float>();
            const glm::vec3 d(std::sin(theta) * std::cos(phi), std::cos(theta),
                              std::sin(theta) * std::sin(phi));
            const float dome = 0.2f + 0.25f * (0.5f + 0.5f * d.y);
            const float soft_light = 2.0f * std::pow(std::max(glm::dot(d, key), 0.0f), 8.0f);
            environment.radiance.emplace_back(dome + soft_light);
        }
    return environment;
}

} // namespace ajar
