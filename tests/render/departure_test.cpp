// Rays meet neither the plane they leave nor the light they aim at, nor a coplanar neighbour of either,
// wherever the scene is, whatever its size, and by way of instances too: where nothing stands between a floor
// and its light, every shadow ray arrives.
#include "render_test.hpp"

#include <glm/gtc/matrix_transform.hpp>

namespace ajar::test {
namespace {

class Departure : public RenderTest {};

struct Place {
    float scale;      // metres
    glm::vec3 offset; // in units of the scale
};

const Place PLACES[] = {{1, {0, 0, 0}},     {1, {3000, -20000, 7000}},
                        {1e-4f, {0, 0, 0}}, {1e-4f, {-9000, 500, 11000}},
                        {1e5f, {0, 0, 0}},  {1e5f, {100, 20000, -300}}};

// A frame whose z axis is no axis of the world, so that no coordinate is exact.
glm::mat4 tilted(const Place& place) {
    const glm::mat4 moved = glm::translate(glm::mat4(1), place.scale * place.offset);
    const glm::mat4 turned = glm::rotate(moved, 0.7f, glm::normalize(glm::vec3(1, 2, 3)));
    return glm::scale(turned, glm::vec3(place.scale));
}

// A floor of seven by seven tiles under a light of three by three, all of one mesh each.
Scene tiles(const Place& place) {
    SceneBuilder builder;
    builder.square({0, 0, 0}, {0, 0, 1}, 0.5f, builder.material(lambert({0.5f, 0.5f, 0.5f})));
    builder.square({0, 0, 0}, {0, 0, -1}, 0.5f, builder.material(emitter({1, 1, 1})));
    const glm::mat4 frame = tilted(place);
    builder.perspective(glm::vec3(frame * glm::vec4(2, 1, 1.2f, 1)), glm::vec3(frame * glm::vec4(0, 0, 0, 1)),
                        0.8f);
    Scene scene = builder.build();
    scene.instances.clear();
    const auto add = [&](std::uint32_t mesh, int side, float height) {
        for (int x = -side; x <= side; ++x)
            for (int y = -side; y <= side; ++y) {
                Instance instance;
                instance.mesh = mesh;
                instance.to_world = frame * glm::translate(glm::mat4(1), glm::vec3(x, y, height));
                scene.instances.push_back(instance);
            }
    };
    add(0, 3, 0);
    add(1, 1, 1.5f);
    return scene;
}

void expect_all_open(const gpu::Device& device, std::uint64_t bake_below_triangles) {
    for (const Place& place : PLACES) {
        const Scene scene = tiles(place);
        RenderSettings settings = small_settings();
        settings.samples = 16;
        settings.strategy = "light";
        settings.bake_below_triangles = bake_below_triangles;
        const RenderStats stats = render_checked(device, scene, settings).stats;
        EXPECT_GT(stats.shadow_rays, 5000u) << "scale " << place.scale;
        EXPECT_EQ(stats.shadow_rays_open, stats.shadow_rays)
            << "scale " << place.scale << ", offset " << place.offset.y;
    }
}

TEST_F(Departure, EveryShadowRayArrivesWhereNothingIsInTheWay) { expect_all_open(device(), 1u << 20); }

TEST_F(Departure, EveryShadowRayArrivesFromInstances) { expect_all_open(device(), 0); }

} // namespace
} // namespace ajar::test
