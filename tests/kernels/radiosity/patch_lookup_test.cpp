// The device finds the patches that the host finds, by texel buffers and by pointers.
#include "radiosity/patch_mesh.hpp"
#include "render/geometry_table.hpp"
#include "render/patch_table.hpp"
#include "shaders/patch_functions.glsl.h"
#include "shaders/shared/specialization.glsl.h"
#include "support/gpu_test.hpp"
#include "support/scene_builder.hpp"

#include <glm/gtc/matrix_transform.hpp>
#include <random>
#include <test_kernels.hpp>

namespace ajar::test {
namespace {

using shared::PatchItem;

// Instances, one of them mirrored, and a triangle without area.
Scene varied_scene() {
    SceneBuilder builder;
    const std::uint32_t grey = builder.material(lambert(glm::vec3(0.5f)));
    builder.room({-2, 0, -2}, {2, 3, 3}, grey);
    builder.sphere({0, 1, 0}, 0.5f, 1, Normals::smooth, grey);
    Scene scene = builder.build();
    Mesh& sphere = scene.meshes[1];
    sphere.triangles.insert(sphere.triangles.begin() + 3, glm::uvec3(4, 4, 5));
    sphere.triangle_materials.push_back(grey);
    Instance mirrored = scene.instances[1];
    mirrored.to_world = glm::scale(glm::translate(glm::mat4(1), {1, 0, 1}), glm::vec3(-0.5f, 0.5f, 0.7f));
    scene.instances.push_back(mirrored);
    return scene;
}

class PatchLookup : public GpuTest {
  protected:
    static std::vector<PatchItem> run(const PatchTable& table, const std::vector<PatchItem>& items,
                                      std::uint32_t texel_buffers) {
        shared::FrameRecord frame{};
        table.describe(frame);
        gpu::Buffer frame_buffer(device(), sizeof frame, "frame");
        frame_buffer.write(std::span<const shared::FrameRecord>(&frame, 1));
        gpu::Bindings bindings(device());
        bindings.uniform(frame_buffer);
        table.bind(bindings);
        const gpu::Kernel<shared::PatchFunctionsArgs> kernel(
            device(), gpu::test_kernels(), "patch_functions",
            {{shared::SPEC_WORKGROUP_SIZE, WORKGROUP_SIZE}, {shared::SPEC_TEXEL_BUFFERS, texel_buffers}});
        gpu::Buffer in_out(device(), items.size() * sizeof(PatchItem), "items");
        in_out.write(std::span<const PatchItem>(items));
        gpu::Commands commands(device());
        commands.bind(bindings);
        kernel.dispatch(commands, {{in_out.address()}, static_cast<std::uint32_t>(items.size()), 0},
                        groups_of(items.size()));
        commands.submit();
        return in_out.read<PatchItem>(0, items.size());
    }
};

TEST_F(PatchLookup, FindsWhatTheHostFinds) {
    const Scene scene = varied_scene();
    GeometryOptions options;
    options.bake_below_triangles = ~std::uint64_t{0};
    const GeometryTable geometry = build_geometry_table(scene, options);
    PatchMesh mesh = PatchMesh::subdivide(scene, {0, 3000});
    std::mt19937 random(1);
    for (int round = 0; round < 8; ++round) { // some trees deeper than others
        std::vector<std::uint8_t> marked(mesh.patches.size());
        for (std::uint8_t& mark : marked) mark = random() % 32 == 0;
        mesh.refine(marked);
    }
    const std::vector<std::uint32_t> roots = patch_roots(geometry.sources, mesh.triangles());
    std::uniform_real_distribution<float> unit(0, 1);
    std::vector<PatchItem> items;
    std::vector<PatchItem> expected;
    std::size_t without = 0;
    for (std::uint32_t t = 0; t < geometry.triangles.size(); ++t)
        for (int i = 0; i < 100; ++i) {
            float u = unit(random);
            float v = unit(random);
            if (u + v > 1) u = 1 - u, v = 1 - v;
            if (i < 3) u = i == 1, v = i == 2; // corners
            items.push_back({t, u, v});
            if (roots[t] == shared::PATCH_NONE) {
                ++without;
                expected.push_back({shared::PATCH_NONE, 0, 0});
                continue;
            }
            const PatchSource& source = mesh.sources[roots[t]]; // whose roots come first
            ASSERT_EQ(source.instance, geometry.sources[t].instance);
            ASSERT_EQ(source.triangle, geometry.sources[t].triangle);
            const PatchPoint found = mesh.find(roots[t], u, v);
            expected.push_back({found.patch, found.u, found.v});
            // Where the patch says it is, the device's triangle is too: vertices are in the same order.
            const shared::TriangleRecord& record = geometry.triangles[t];
            const auto vertex = [&](int k) { return glm::vec3(record.x[k], record.y[k], record.z[k]); };
            const glm::vec3 there = vertex(0) + u * (vertex(1) - vertex(0)) + v * (vertex(2) - vertex(0));
            const auto& corners = mesh.patches[found.patch].vertices;
            const auto corner = [&](int k) { return mesh.positions[corners[k]]; };
            const glm::vec3 here =
                corner(0) + found.u * (corner(1) - corner(0)) + found.v * (corner(2) - corner(0));
            ASSERT_LT(glm::distance(there, here), 1e-5f);
        }
    EXPECT_EQ(without, 200u);
    const PatchTable table(device(), geometry.sources, mesh.triangles(), mesh.nodes);
    for (const std::uint32_t texel_buffers : {0u, 1u}) {
        const std::vector<PatchItem> found = run(table, items, texel_buffers);
        for (std::size_t i = 0; i < items.size(); ++i) {
            ASSERT_EQ(found[i].index, expected[i].index)
                << items[i].index << " " << items[i].u << " " << items[i].v;
            if (expected[i].index == shared::PATCH_NONE) continue;
            ASSERT_EQ(found[i].u, expected[i].u);
            ASSERT_EQ(found[i].v, expected[i].v);
        }
    }
}

} // namespace
} // namespace ajar::test
