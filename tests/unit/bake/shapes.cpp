#include "unit/bake/shapes.hpp"

#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <random>

namespace ajar::test {

namespace {

Scene of_mesh(Mesh mesh) {
    Scene scene;
    mesh.normals.assign(mesh.positions.size(), {0, 1, 0});
    mesh.triangle_materials.assign(mesh.triangles.size(), 0);
    scene.materials.push_back(lambert({0.5f, 0.5f, 0.5f}));
    scene.meshes.push_back(std::move(mesh));
    scene.instances.push_back({"it", 0, glm::mat4(1)});
    return scene;
}

// A grid of (columns + 1) x (rows + 1) vertices at place(u, v), u and v from 0 to 1.
template <class Place> Scene grid(std::uint32_t columns, std::uint32_t rows, Place&& place) {
    Mesh mesh;
    for (std::uint32_t j = 0; j <= rows; ++j)
        for (std::uint32_t i = 0; i <= columns; ++i)
            mesh.positions.push_back(place(static_cast<float>(i) / static_cast<float>(columns),
                                           static_cast<float>(j) / static_cast<float>(rows)));
    for (std::uint32_t j = 0; j < rows; ++j)
        for (std::uint32_t i = 0; i < columns; ++i) {
            const std::uint32_t v = i + (columns + 1) * j, up = v + columns + 1;
            mesh.triangles.emplace_back(v, v + 1, up + 1);
            mesh.triangles.emplace_back(v, up + 1, up);
        }
    return of_mesh(std::move(mesh));
}

Scene ramp() { // three turns above one another, hardly inclined
    return grid(96, 2, [](float u, float v) {
        const float angle = u * 6 * glm::pi<float>(), radius = 1 + v;
        return glm::vec3(radius * std::cos(angle), u, radius * std::sin(angle));
    });
}

Scene torus() {
    return grid(40, 24, [](float u, float v) {
        const float a = u * glm::two_pi<float>(), b = v * glm::two_pi<float>();
        const float radius = 2 + 0.7f * std::cos(b);
        return glm::vec3(radius * std::cos(a), 0.7f * std::sin(b), radius * std::sin(a));
    });
}

Scene hills() {
    return grid(30, 30, [](float u, float v) {
        return glm::vec3(10 * u, std::sin(9 * u) * std::cos(7 * v), 10 * v);
    });
}

Scene soup() {
    std::mt19937 random(11);
    std::normal_distribution<float> normal;
    const auto point = [&] { return glm::vec3(normal(random), normal(random), normal(random)); };
    Mesh mesh;
    for (std::uint32_t i = 0; i < 200; ++i) {
        const glm::vec3 middle = 3.0f * point();
        const float size = std::exp(normal(random));
        for (int k = 0; k < 3; ++k) mesh.positions.push_back(middle + size * point());
        mesh.triangles.emplace_back(3 * i, 3 * i + 1, 3 * i + 2);
    }
    return of_mesh(std::move(mesh));
}

// A floor of two triangles, and specks of 1e-5 of its size upon a corner of it.
Scene specks() {
    Scene scene = grid(1, 1, [](float u, float v) { return glm::vec3(100 * u, 0, 100 * v); });
    const Scene small = grid(7, 5, [](float u, float v) { return glm::vec3(u, 1e-4f * v, v); });
    scene.meshes.push_back(small.meshes[0]);
    scene.instances.push_back({"specks", 1, glm::scale(glm::mat4(1), glm::vec3(1e-3f))});
    return scene;
}

Scene instances() {
    SceneBuilder builder;
    builder.sphere({0, 0, 0}, 1, 2, Normals::smooth, builder.material(lambert({1, 1, 1})));
    Scene scene = builder.build();
    for (const glm::vec3& scale : {glm::vec3(-1, 1, 1), glm::vec3(3, 0.2f, 1), glm::vec3(0.01f)})
        scene.instances.push_back(
            {"again", 0, glm::scale(glm::translate(glm::mat4(1), 4.0f * scale), scale)});
    return scene;
}

Scene room() {
    SceneBuilder builder;
    const std::uint32_t grey = builder.material(lambert({0.5f, 0.5f, 0.5f}));
    builder.room({-1, -1, -1}, {1, 1, 1.5f}, grey);
    builder.box({-0.3f, -1, -0.3f}, {0.3f, 0.2f, 0.1f}, grey);
    return builder.build();
}

} // namespace

std::vector<std::pair<std::string, Scene>> awkward_scenes() {
    return {{"room", room()}, {"ramp", ramp()},     {"torus", torus()},        {"hills", hills()},
            {"soup", soup()}, {"specks", specks()}, {"instances", instances()}};
}

} // namespace ajar::test
