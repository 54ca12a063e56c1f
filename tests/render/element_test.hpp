// Fixture for tests of light that arrives on surface elements.
#pragma once

#include "render_test.hpp"

#include <functional>
#include <vector>

namespace ajar::test {

// An irradiance (W/m^2) that depends on the place alone.
using Field = std::function<glm::dvec3(const glm::dvec3&)>;

// Where barycentrics of the element's triangle are in the world.
glm::dvec3 place_of(const Scene& scene, const SceneElement& e, const glm::dvec2& at);

// Pieces of every triangle of an instance: as many rows as asked for, parallelograms and the triangles that
// end each row.
std::vector<SceneElement> pieces(const Scene& scene, std::uint32_t instance, int rows,
                                 std::uint32_t flags = 0);

// Direct light alone.
RenderSettings element_settings();

// A floor, instance 0, and what Lambert's formula says that it gets from the light above it.
Scene under_a_square_light();
glm::dvec3 of_the_square_light(const glm::dvec3& at);

class Irradiance : public RenderTest {
  protected:
    static ElementRadiance irradiance(const Scene& scene, const std::vector<SceneElement>& elements,
                                      const RenderSettings& settings);

    // Each element by the variance that the result states, which does not know that samples are stratified,
    // and the mean of all by the residuals' own spread.
    static void expect_irradiance(const Scene& scene, const std::vector<SceneElement>& elements,
                                  const RenderSettings& settings, const Field& field, double relative = 1e-5);
};

} // namespace ajar::test
