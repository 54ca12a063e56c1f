// What a polygon of uniform radiance brings to a point, in closed form.
#pragma once

#include <glm/glm.hpp>
#include <vector>

namespace ajar::test {

// Irradiance (W/m^2) from a polygon of unit radiance, wholly above the horizon of `normal` (Lambert 1760):
// half the sum over the edges of the angle each subtends times the cosine between `normal` and its plane's
// normal. Divided by pi it is the form factor from the point to the polygon.
double polygon_irradiance(const std::vector<glm::dvec3>& corners, const glm::dvec3& at,
                          const glm::dvec3& normal);

} // namespace ajar::test
