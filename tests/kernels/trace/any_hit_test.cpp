// connect answers what brute force answers, ray by ray, whatever the variant.
#include "reference.hpp"
#include "soups.hpp"
#include "support/gpu_test.hpp"
#include "trace_rig.hpp"

#include <algorithm>

namespace ajar::test {
namespace {

class Connect : public GpuTest {};

std::vector<RigOptions> all_variants() {
    return trace_variants(&RigOptions::connect_option, {shared::CONNECT_TOGETHER, shared::CONNECT_APART});
}

// The same rays, cut at random: some before, some behind the first triangle, and some just at it.
std::vector<shared::ShadowRay> shadow_rays(const std::vector<shared::PathState>& rays,
                                           const std::vector<ReferenceHit>& hits) {
    Random random(11);
    std::vector<shared::ShadowRay> shadows;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        shared::ShadowRay ray{};
        ray.origin = rays[i].origin;
        ray.direction = rays[i].direction;
        ray.leaves = rays[i].leaves;
        const float far = hits[i].triangle == shared::NO_TRIANGLE ? 1.0f : hits[i].t;
        switch (random() % 4) {
        case 0: ray.reach = far * uniform(random, 0.2f, 1); break;
        case 1: ray.reach = far * uniform(random, 1, 3); break;
        case 2: ray.reach = far; break;
        default: ray.reach = 3.0e38f;
        }
        shadows.push_back(ray);
    }
    return shadows;
}

TEST_F(Connect, AnswersWhatBruteForceAnswersInRandomSoups) {
    for (const std::uint32_t count : {7u, 1000u}) {
        const TraceScene scene{{random_soup(count, count)}, {}};
        const auto rays = random_rays(scene.meshes[0], 2001, 1); // not a multiple of anything
        std::vector<ReferenceHit> hits;
        std::vector<shared::ShadowRay> shadows;
        for (const RigOptions& variant : all_variants()) {
            TraceRig rig(device(), scene, variant);
            if (hits.empty()) {
                for (const shared::PathState& ray : rays)
                    hits.push_back(reference_closest(rig.triangles(), ray.origin, ray.direction));
                shadows = shadow_rays(rays, hits);
            }
            const RigResult result = rig.connect(shadows);
            ASSERT_EQ(result.exhausted, 0u);
            for (std::size_t i = 0; i < rays.size(); ++i)
                ASSERT_EQ(result.open[i], !(hits[i].t < shadows[i].reach)) << "ray " << i;
        }
        const auto blocked = std::ranges::count_if(
            shadows, [&](const auto& ray) { return hits[std::size_t(&ray - shadows.data())].t < ray.reach; });
        EXPECT_GT(blocked, 100) << "the rays test too little";
    }
}

TEST_F(Connect, DoesNotSeeTheTriangleThatARayLeaves) {
    const std::vector<bvh::Triangle> soup = random_soup(60, 3);
    const TraceScene scene{{soup}, {}};
    const auto rays = random_rays(soup, 500, 4);
    for (const RigOptions& variant : all_variants()) {
        TraceRig rig(device(), scene, variant);
        std::vector<shared::ShadowRay> shadows;
        std::vector<bool> expected;
        for (const shared::PathState& ray : rays) {
            const ReferenceHit first = reference_closest(rig.triangles(), ray.origin, ray.direction);
            shared::ShadowRay shadow{};
            shadow.origin = ray.origin;
            shadow.direction = ray.direction;
            shadow.leaves = first.triangle;
            shadow.reach = 3.0e38f;
            shadows.push_back(shadow);
            bool open = true;
            const ReferenceRay reference(ray.origin, ray.direction);
            for (std::uint32_t t = 0; t < rig.triangles().size(); ++t) {
                ReferenceHit hit;
                if (t != first.triangle) reference.test(rig.triangles()[t], t, hit);
                open = open && hit.triangle == shared::NO_TRIANGLE;
            }
            expected.push_back(open);
        }
        EXPECT_EQ(rig.connect(shadows).open, expected);
    }
}

} // namespace
} // namespace ajar::test
