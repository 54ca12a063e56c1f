// Triangles that are there only in part: extend and connect find what brute force finds, whatever the
// variant.
#include "reference.hpp"
#include "soups.hpp"
#include "support/gpu_test.hpp"
#include "support/statistics.hpp"
#include "trace_rig.hpp"

namespace ajar::test {
namespace {

using namespace shared;

class Alpha : public GpuTest {};

MaterialRecord material(std::uint32_t flags, float alpha) {
    MaterialRecord record{};
    record.base_color = glm::vec4(0.5f, 0.5f, 0.5f, alpha);
    record.flags = flags;
    record.alpha_cutoff = 0.5f;
    record.base_color_texture = record.metallic_roughness_texture = NO_TEXTURE;
    record.normal_texture = record.emission_texture = NO_TEXTURE;
    return record;
}

// By index: opaque from both sides, holes, there and looked at, opaque.
std::vector<MaterialRecord> masks() {
    return {material(MATERIAL_DOUBLE_SIDED, 1), material(MATERIAL_MASK | MATERIAL_DOUBLE_SIDED, 0.25f),
            material(MATERIAL_MASK, 0.75f), material(0, 1)};
}

// Whether a hit counts, by what the materials say.
auto masked(const TraceRig& rig, const TraceScene& scene) {
    return [&rig, &scene](const ReferenceHit& hit) {
        const MaterialRecord& m = scene.materials[rig.triangles()[hit.triangle].material];
        const bool hole = (m.flags & MATERIAL_MASK) != 0 && m.base_color.w < m.alpha_cutoff;
        return !hole && !(scene.cull_backfaces && hit.back_face && (m.flags & MATERIAL_DOUBLE_SIDED) == 0);
    };
}

std::vector<ReferenceHit> references(const TraceRig& rig, const TraceScene& scene,
                                     const std::vector<PathState>& rays) {
    std::vector<ReferenceHit> hits;
    for (const PathState& ray : rays)
        hits.push_back(reference_closest(rig.triangles(), ray.origin, ray.direction, masked(rig, scene)));
    return hits;
}

std::vector<RigOptions> extend_variants() {
    return trace_variants(&RigOptions::extend_option, {EXTEND_CAMERA, EXTEND_BOUNCE});
}

std::vector<RigOptions> connect_variants() {
    return trace_variants(&RigOptions::connect_option, {CONNECT_TOGETHER, CONNECT_APART});
}

void expect_reference(const RigResult& result, const std::vector<ReferenceHit>& expected) {
    ASSERT_EQ(result.exhausted, 0u);
    for (std::size_t i = 0; i < expected.size(); ++i) {
        ASSERT_EQ(result.paths[i].triangle, expected[i].triangle) << "ray " << i;
        if (expected[i].triangle == NO_TRIANGLE) continue;
        ASSERT_EQ(result.paths[i].u, expected[i].u) << "ray " << i;
        ASSERT_EQ(result.paths[i].v, expected[i].v) << "ray " << i;
    }
}

std::vector<ShadowRay> to_shadow_rays(const std::vector<PathState>& rays, float reach) {
    std::vector<ShadowRay> shadows;
    for (const PathState& ray : rays) {
        ShadowRay shadow{};
        shadow.origin = ray.origin;
        shadow.direction = ray.direction;
        shadow.leaves = NO_TRIANGLE;
        shadow.reach = reach;
        shadows.push_back(shadow);
    }
    return shadows;
}

TEST_F(Alpha, RaysPassHolesAndBackFacesThatAreCulled) {
    for (const bool cull : {false, true}) {
        const TraceScene scene{{random_soup(1000, 8)}, {}, masks(), cull};
        const auto rays = random_rays(scene.meshes[0], 1500, 1);
        std::vector<ReferenceHit> expected;
        for (const RigOptions& variant : extend_variants()) {
            TraceRig rig(device(), scene, variant);
            if (expected.empty()) expected = references(rig, scene, rays);
            expect_reference(rig.extend(rays), expected);
        }
    }
}

TEST_F(Alpha, ShadowRaysPassHolesAndBackFacesThatAreCulled) {
    for (const bool cull : {false, true}) {
        const TraceScene scene{{random_soup(300, 9)}, {}, masks(), cull};
        const auto rays = random_rays(scene.meshes[0], 1501, 2);
        const float reach = 0.7f;
        std::vector<bool> expected;
        for (const RigOptions& variant : connect_variants()) {
            TraceRig rig(device(), scene, variant);
            if (expected.empty()) {
                for (const ReferenceHit& hit : references(rig, scene, rays))
                    expected.push_back(!(hit.t < reach));
            }
            const RigResult result = rig.connect(to_shadow_rays(rays, reach));
            ASSERT_EQ(result.exhausted, 0u);
            EXPECT_EQ(result.open, expected);
        }
    }
}

// A mirrored mesh keeps its front: winding and determinant change sign together (glTF 2.0, 3.7.4).
TEST_F(Alpha, RaysPassHolesAndCulledBackFacesOfInstances) {
    const glm::vec4 y(0, 1, 0, 0), z(0, 0, 1, 0);
    for (const float mirror : {1.0f, -1.0f}) {
        const TraceScene scene{{random_soup(100, 3), random_soup(200, 4)},
                               {{1, {glm::vec4(mirror, 0, 0, 0), y, z}}},
                               masks(),
                               true};
        const auto rays = random_rays(scene.meshes[1], 1000, 5);
        const float reach = 0.7f;
        for (const RigOptions& variant : trace_variants(&RigOptions::extend_option, {EXTEND_BOUNCE})) {
            TraceRig rig(device(), scene, variant);
            const std::span<const TriangleRecord> all = rig.triangles();
            const std::uint32_t first = rig.first_triangle(1);
            std::vector<ReferenceHit> expected;
            std::vector<bool> open;
            for (const PathState& ray : rays) {
                const glm::vec3 m(mirror, 1, 1);
                ReferenceHit hit =
                    reference_closest(all.first(first), ray.origin, ray.direction, masked(rig, scene));
                const ReferenceHit other =
                    reference_closest(all, ray.origin * m, ray.direction * m, [&](const ReferenceHit& h) {
                        return h.triangle >= first && masked(rig, scene)(h);
                    });
                if (other.t < hit.t) hit = other;
                expected.push_back(hit);
                open.push_back(!(hit.t < reach));
            }
            expect_reference(rig.extend(rays), expected);
            EXPECT_EQ(rig.connect(to_shadow_rays(rays, reach)).open, open);
        }
    }
}

TEST_F(Alpha, BlendIsThereAsOftenAsItsAlphaSays) {
    const float alpha = 0.3f;
    const bvh::Triangle triangle{{glm::vec3(-9, -9, 0), glm::vec3(9, -9, 0), glm::vec3(0, 9, 0)}};
    const TraceScene scene{{{triangle}}, {}, {material(MATERIAL_BLEND, alpha)}, false};
    std::vector<PathState> rays(4000, make_ray(glm::vec3(0, 0, 1), glm::vec3(0, 0, -1)));
    for (std::size_t i = 0; i < rays.size(); ++i) rays[i].home = std::uint32_t(i);
    std::vector<std::uint32_t> first;
    for (const RigOptions& variant : extend_variants()) {
        TraceRig rig(device(), scene, variant);
        std::vector<std::uint32_t> hits;
        for (const PathState& path : rig.extend(rays).paths) hits.push_back(path.triangle);
        if (first.empty()) first = hits;
        EXPECT_EQ(hits, first) << "another variant tossed another coin";
    }
    Moments there;
    for (const std::uint32_t hit : first) there.add(hit == 0 ? 1 : 0);
    EXPECT_GT(mean_p_value(there, alpha), SIGNIFICANCE);
}

} // namespace
} // namespace ajar::test
