#include "support/lambert.hpp"

#include <cmath>

namespace ajar::test {

double polygon_irradiance(const std::vector<glm::dvec3>& corners, const glm::dvec3& at,
                          const glm::dvec3& normal) {
    double sum = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const glm::dvec3 a = glm::normalize(corners[i] - at);
        const glm::dvec3 b = glm::normalize(corners[(i + 1) % corners.size()] - at);
        sum += std::acos(glm::dot(a, b)) * glm::dot(glm::normalize(glm::cross(a, b)), normal);
    }
    return 0.5 * std::abs(sum);
}

} // namespace ajar::test
