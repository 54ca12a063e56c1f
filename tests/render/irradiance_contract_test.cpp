// What holds of the irradiance of elements besides its value: equal bits, interruption, refusals.
#include "base/error.hpp"
#include "element_test.hpp"

#include <bit>

namespace ajar::test {
namespace {

void expect_same_bits(const ElementRadiance& a, const ElementRadiance& b) {
    ASSERT_EQ(a.irradiance.size(), b.irradiance.size());
    std::size_t different = 0;
    for (std::size_t i = 0; i < a.irradiance.size(); ++i)
        for (int c = 0; c < 3; ++c)
            different += std::bit_cast<std::uint32_t>(a.irradiance[i][c]) !=
                             std::bit_cast<std::uint32_t>(b.irradiance[i][c]) ||
                         std::bit_cast<std::uint32_t>(a.variance[i][c]) !=
                             std::bit_cast<std::uint32_t>(b.variance[i][c]);
    EXPECT_EQ(different, 0u) << "of " << 3 * a.irradiance.size();
}

TEST_F(Irradiance, IsTheSameBitsWhateverThePoolTheSlicesAndTheWorkgroups) {
    const Scene scene = under_a_square_light();
    const std::vector<SceneElement> elements = pieces(scene, 0, 11); // fill no segment evenly
    RenderSettings settings = element_settings();
    settings.samples = 6;
    settings.max_bounces = 3;
    const ElementRadiance reference = irradiance(scene, elements, settings);
    for (const auto& [segment, pool] : {std::pair{64u, 1u}, {64u, 3000u}, {1024u, 3000u}}) {
        settings.segment_paths = segment;
        settings.pool_paths = pool;
        expect_same_bits(reference, irradiance(scene, elements, settings));
    }
    settings.slice_seconds = 1e-6;
    expect_same_bits(reference, irradiance(scene, elements, settings));
    for (const std::uint32_t workgroup : {8u, 64u}) {
        gpu::DeviceOptions options;
        options.workgroup_size = workgroup;
        options.force_pointers = true;
        const gpu::Device other(options);
        expect_same_bits(reference, Renderer(other, scene, {}).irradiance(elements, settings));
    }
}

TEST_F(Irradiance, OfAnElementDoesNotDependOnThoseBehindIt) {
    const Scene scene = under_a_square_light();
    const std::vector<SceneElement> elements = pieces(scene, 0, 5);
    RenderSettings settings = element_settings();
    ElementRadiance all = irradiance(scene, elements, settings);
    const ElementRadiance few = irradiance(scene, {elements.begin(), elements.begin() + 7}, settings);
    all.irradiance.resize(7);
    all.variance.resize(7);
    expect_same_bits(all, few);
}

TEST_F(Irradiance, StopsWhenAskedTo) {
    const Scene scene = under_a_square_light();
    RenderSettings settings = element_settings();
    const ElementRadiance result =
        Renderer(device(), scene, {}).irradiance(pieces(scene, 0, 5), settings, [](const Progress& p) {
            return p.done < 2;
        });
    EXPECT_TRUE(result.stats.interrupted);
    EXPECT_LT(result.stats.samples, settings.samples);
    for (const glm::vec3& e : result.irradiance) EXPECT_GT(e.x, 0) << "finished samples count";
}

TEST_F(Irradiance, RefusesIntegratorsOfCameraRays) {
    const Scene scene = under_a_square_light();
    RenderSettings settings = element_settings();
    for (const Choice& row : integrators()) {
        settings.integrator = row.name;
        const std::string name = row.name;
        if (name == "path" || name == "direct" || name == "ao")
            EXPECT_NO_THROW(irradiance(scene, pieces(scene, 0, 1), settings)) << name;
        else
            EXPECT_THROW(Renderer(device(), scene, {}).irradiance(pieces(scene, 0, 1), settings), Error)
                << name;
    }
}

TEST_F(Irradiance, OfNothingIsNothing) {
    const Scene scene = under_a_square_light();
    EXPECT_TRUE(Renderer(device(), scene, {}).irradiance({}, element_settings()).irradiance.empty());
}

} // namespace
} // namespace ajar::test
