// extend finds what brute force finds, bit for bit, whatever the variant, and however large the world.
#include "reference.hpp"
#include "soups.hpp"
#include "support/gpu_test.hpp"
#include "trace_rig.hpp"

#include <algorithm>

namespace ajar::test {
namespace {

class Extend : public GpuTest {};

std::vector<RigOptions> all_variants() {
    return trace_variants(&RigOptions::extend_option, {shared::EXTEND_CAMERA, shared::EXTEND_BOUNCE});
}

void expect_reference(TraceRig& rig, const std::vector<shared::PathState>& rays,
                      const std::vector<ReferenceHit>& expected) {
    const RigResult result = rig.extend(rays);
    ASSERT_EQ(result.exhausted, 0u);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const shared::PathState& seen = result.paths[i];
        ASSERT_EQ(seen.triangle, expected[i].triangle) << "ray " << i;
        if (expected[i].triangle == shared::NO_TRIANGLE) continue;
        ASSERT_EQ(seen.u, expected[i].u) << "ray " << i;
        ASSERT_EQ(seen.v, expected[i].v) << "ray " << i;
        ASSERT_EQ(seen.instance, 0u);
    }
}

std::vector<ReferenceHit> references(const TraceRig& rig, const std::vector<shared::PathState>& rays) {
    std::vector<ReferenceHit> hits;
    for (const shared::PathState& ray : rays)
        hits.push_back(reference_closest(rig.triangles(), ray.origin, ray.direction));
    return hits;
}

TEST_F(Extend, FindsWhatBruteForceFindsInRandomSoups) {
    for (const std::uint32_t count : {1u, 2u, 7u, 60u, 1000u}) {
        const TraceScene scene{{random_soup(count, count)}, {}};
        const auto rays = random_rays(scene.meshes[0], 2000, 1);
        std::vector<ReferenceHit> expected;
        for (const RigOptions& variant : all_variants()) {
            TraceRig rig(device(), scene, variant);
            if (expected.empty()) expected = references(rig, rays);
            expect_reference(rig, rays, expected);
        }
        const auto hits = std::count_if(expected.begin(), expected.end(), [](const ReferenceHit& hit) {
            return hit.triangle != shared::NO_TRIANGLE;
        });
        EXPECT_GT(hits, 200) << "the rays test too little";
    }
}

TEST_F(Extend, FindsTheSameInWorldsOfEverySize) {
    const std::vector<bvh::Triangle> soup = random_soup(300, 5);
    const std::vector<shared::PathState> rays = random_rays(soup, 1000, 6);
    for (const int exponent : {-40, -20, 20, 40}) {
        TraceScene scene{{soup}, {}};
        for (bvh::Triangle& triangle : scene.meshes[0]) {
            for (glm::vec3& vertex : triangle.vertices) vertex = glm::ldexp(vertex, glm::ivec3(exponent));
        }
        std::vector<shared::PathState> scaled = rays;
        for (shared::PathState& ray : scaled) ray.origin = glm::ldexp(ray.origin, glm::ivec3(exponent));
        TraceRig rig(device(), scene, {});
        expect_reference(rig, scaled, references(rig, scaled));
    }
}

TEST_F(Extend, FindsTheSameFarFromTheOrigin) {
    TraceScene scene{{random_soup(300, 7)}, {}};
    std::vector<shared::PathState> rays = random_rays(scene.meshes[0], 1000, 8);
    const glm::vec3 shift(3000, -20000, 70000);
    for (bvh::Triangle& triangle : scene.meshes[0]) {
        for (glm::vec3& vertex : triangle.vertices) vertex += shift;
    }
    for (shared::PathState& ray : rays) ray.origin += shift;
    TraceRig rig(device(), scene, {});
    expect_reference(rig, rays, references(rig, rays));
}

TEST_F(Extend, FindsNothingWhereThereIsNothing) {
    for (const RigOptions& variant : all_variants()) {
        TraceRig rig(device(), {{{}}, {}}, variant);
        const RigResult result = rig.extend(random_rays(random_soup(1, 1), 100, 1));
        for (const shared::PathState& path : result.paths) EXPECT_EQ(path.triangle, shared::NO_TRIANGLE);
    }
}

TEST_F(Extend, NeverHitsATriangleWithoutArea) {
    std::vector<bvh::Triangle> triangles;
    for (int i = 0; i < 50; ++i) {
        const glm::vec3 p(float(i) * 0.1f, 0, 0);
        triangles.push_back({{p, p, p}});
        triangles.push_back({{p, p + glm::vec3(0, 1, 0), p + glm::vec3(0, 2, 0)}});
    }
    TraceRig rig(device(), {{triangles}, {}}, {});
    const RigResult result = rig.extend(random_rays(triangles, 1000, 3));
    for (const shared::PathState& path : result.paths) EXPECT_EQ(path.triangle, shared::NO_TRIANGLE);
}

} // namespace
} // namespace ajar::test
