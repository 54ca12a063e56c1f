// Fixture for tests of whole radiosity solutions.
#pragma once

#include "radiosity/radiosity.hpp"
#include "support/gpu_test.hpp"
#include "support/scene_builder.hpp"

namespace ajar::test {

class RadiosityTest : public GpuTest {
  protected:
    // Solves and expects that nothing went wrong: convergence, no warning, no exhausted loop.
    static RadiositySolution solve(const Scene& scene, const RadiositySettings& settings);

    // The vector's value, expected on every side that takes part.
    static void expect_everywhere(const RadiositySolution& solution, const std::vector<glm::vec3>& values,
                                  const glm::dvec3& right, double relative);
};

// At least `patches`, so many rays each.
RadiositySettings settings_of(std::uint32_t patches, std::uint32_t rays);

// A closed cube of 2 m whose walls emit e and reflect a.
Scene furnace_room(const glm::vec3& a, const glm::vec3& e);

// The Cornell box's plan in round numbers: white walls, one red and one green, two boxes, a square light.
Scene small_cornell_box();

} // namespace ajar::test
