// extend finds what brute force finds, bit for bit, whatever the variant.
#include "reference.hpp"
#include "soups.hpp"
#include "support/gpu_test.hpp"
#include "trace_rig.hpp"

namespace ajar::test {
namespace {

class Extend : public GpuTest {};

void expect_reference(TraceRig& rig, const std::vector<shared::PathState>& rays) {
    const RigResult result = rig.extend(rays);
    ASSERT_EQ(result.exhausted, 0u);
    std::size_t hits = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const ReferenceHit expected = reference_closest(rig.triangles(), rays[i].origin, rays[i].direction);
        const shared::PathState& seen = result.paths[i];
        ASSERT_EQ(seen.triangle, expected.triangle) << "ray " << i;
        if (expected.triangle == shared::NO_TRIANGLE) continue;
        ++hits;
        ASSERT_EQ(seen.u, expected.u) << "ray " << i;
        ASSERT_EQ(seen.v, expected.v) << "ray " << i;
        ASSERT_EQ(seen.instance, 0u);
    }
    EXPECT_GT(hits, rays.size() / 10) << "the rays test too little";
}

TEST_F(Extend, FindsWhatBruteForceFindsInRandomSoups) {
    for (const std::uint32_t count : {1u, 2u, 7u, 60u, 1000u}) {
        const TraceScene scene{{random_soup(count, count)}, {}};
        for (const bool texel_buffers : {true, false}) {
            TraceRig rig(device(), scene, {.texel_buffers = texel_buffers});
            expect_reference(rig, random_rays(scene.meshes[0], 2000, 1));
        }
    }
}

TEST_F(Extend, FindsNothingWhereThereIsNothing) {
    TraceRig rig(device(), {{{}}, {}}, {});
    const RigResult result = rig.extend(random_rays(random_soup(1, 1), 100, 1));
    for (const shared::PathState& path : result.paths) EXPECT_EQ(path.triangle, shared::NO_TRIANGLE);
}

} // namespace
} // namespace ajar::test
