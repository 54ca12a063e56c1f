// Closed rooms of one emission and one reflectance, where L = E / (1 - R) whatever the shape, the mesh and
// the noise of form factors, as long as rows sum to 1.
#include "radiosity_test.hpp"

#include <algorithm>
#include <glm/gtc/constants.hpp>

namespace ajar::test {
namespace {

class RadiosityFurnace : public RadiosityTest, public testing::WithParamInterface<const char*> {};
INSTANTIATE_TEST_SUITE_P(Solvers, RadiosityFurnace, testing::Values("jacobi", "gauss-seidel", "shooting"),
                         [](const auto& row) {
                             std::string name = row.param;
                             std::replace(name.begin(), name.end(), '-', '_');
                             return name;
                         });

TEST_P(RadiosityFurnace, EveryPatchHasItsClosedForm) {
    const glm::dvec3 a(0.25, 0.5, 0.9);
    const glm::dvec3 e(1, 0.5, 2);
    RadiositySettings settings = settings_of(200, 64);
    settings.solver = GetParam();
    settings.direct = "form-factors";
    settings.tolerance = 1e-5f;
    const RadiositySolution solution = solve(furnace_room(a, e), settings);
    expect_everywhere(solution, solution.radiance, e / (1.0 - a), 1e-4);
    expect_everywhere(solution, solution.irradiance, glm::pi<double>() * e / (1.0 - a), 1e-4);
    expect_everywhere(solution, solution.emission, e, 1e-6);
    expect_everywhere(solution, solution.reflectance, a, 1e-6);
    EXPECT_EQ(solution.stats.sky_share, 0);
    EXPECT_EQ(solution.stats.nowhere_share, 0);
    // Backs of the walls take no part.
    EXPECT_EQ(solution.stats.sides, solution.stats.patches);
}

} // namespace
} // namespace ajar::test
