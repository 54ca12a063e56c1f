#include "bench_scenes.hpp"

#include "import/import.hpp"
#include "kernels/trace/soups.hpp"

#include <cmath>
#include <filesystem>

namespace ajar::bench {
namespace {

using Triangles = std::vector<bvh::Triangle>;
using test::uniform;

void add_quad(Triangles& out, glm::vec3 a, glm::vec3 b, glm::vec3 c, glm::vec3 d) {
    out.push_back({{a, b, c}});
    out.push_back({{a, c, d}});
}

// A smooth function of space between about -1 and 1.
float waves(const glm::vec3& p) {
    return (std::sin(p.x + 1.3f * std::sin(p.z)) + std::sin(1.7f * p.y + std::sin(2.1f * p.x)) +
            std::sin(1.9f * p.z + 1.1f * std::sin(p.y))) /
           3;
}

// A parallelogram of n x n cells, raised along `up` by noise.
void add_rough_wall(Triangles& out, glm::vec3 corner, glm::vec3 u, glm::vec3 v, glm::vec3 up, int n,
                    float height) {
    const auto vertex = [&](int i, int j) {
        const glm::vec3 p = corner + u * (float(i) / float(n)) + v * (float(j) / float(n));
        const bool edge = i == 0 || j == 0 || i == n || j == n;
        return edge ? p : p + up * (height * (0.7f * waves(p * 6.0f) + 0.3f * waves(p * 23.0f)));
    };
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j)
            add_quad(out, vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1));
    }
}

// A sphere of rows x 2 rows cells, its radius varied by noise.
void add_blob(Triangles& out, glm::vec3 center, float radius, int rows, float roughness, float frequency) {
    const auto vertex = [&](int i, int j) {
        const float theta = 3.14159265f * float(i) / float(rows);
        const float phi = 3.14159265f * float(j % (2 * rows)) / float(rows);
        const glm::vec3 d(std::sin(theta) * std::cos(phi), std::cos(theta), std::sin(theta) * std::sin(phi));
        const glm::vec3 at = (d + center) * frequency;
        return center + d * radius * (1 + roughness * (0.8f * waves(at) + 0.2f * waves(at * 5.0f)));
    };
    for (int i = 0; i < rows; ++i) {
        for (int j = 0; j < 2 * rows; ++j) {
            if (i > 0) out.push_back({{vertex(i, j), vertex(i, j + 1), vertex(i + 1, j)}});
            if (i + 1 < rows) out.push_back({{vertex(i, j + 1), vertex(i + 1, j + 1), vertex(i + 1, j)}});
        }
    }
}

void add_foliage(Triangles& out, glm::vec3 center, float radius, int leaves, std::uint32_t seed) {
    test::Random random(seed);
    for (int i = 0; i < leaves; ++i) {
        const glm::vec3 at = center + test::random_direction(random) * radius * std::cbrt(uniform(random));
        const glm::vec3 a = test::random_direction(random) * uniform(random, 0.02f, 0.06f);
        const glm::vec3 b = glm::cross(a, test::random_direction(random)) * 0.5f;
        add_quad(out, at - a, at - b, at + a, at + b);
    }
}

// The room [-1, 1] x [0, 2] x [-1, 1] times `size`, closed, with a light just below the ceiling.
void add_room(BenchScene& scene, glm::vec3 size, int cells, float height) {
    Triangles& out = scene.triangles;
    const glm::vec3 x(2 * size.x, 0, 0), y(0, 2 * size.y, 0), z(0, 0, 2 * size.z);
    const glm::vec3 corner(-size.x, 0, -size.z);
    add_rough_wall(out, corner, z, x, {0, 1, 0}, cells, height);
    add_rough_wall(out, corner + y, x, z, {0, -1, 0}, cells, height);
    add_rough_wall(out, corner, x, y, {0, 0, 1}, cells, height);
    add_rough_wall(out, corner + z, y, x, {0, 0, -1}, cells, height);
    add_rough_wall(out, corner, y, z, {1, 0, 0}, cells, height);
    add_rough_wall(out, corner + x, z, y, {-1, 0, 0}, cells, height);
    scene.light_corner = glm::vec3(-0.25f * size.x, 1.9f * size.y, -0.25f * size.z);
    scene.light_u = {0.5f * size.x, 0, 0};
    scene.light_v = {0, 0, 0.5f * size.z};
    const glm::vec3 c = scene.light_corner;
    add_quad(out, c, c + scene.light_u, c + scene.light_u + scene.light_v, c + scene.light_v);
}

} // namespace

BenchScene small_scene() {
    BenchScene scene;
    scene.name = "small";
    add_room(scene, {1, 1, 1}, 1, 0);
    add_blob(scene.triangles, {-0.4f, 0.35f, -0.3f}, 0.35f, 15, 0, 1);
    add_blob(scene.triangles, {0.45f, 0.3f, 0.2f}, 0.3f, 11, 0, 1);
    scene.eye = {0, 1, 0.98f};
    scene.target = {0, 0.9f, 0};
    scene.yfov = 1.2f;
    return scene;
}

BenchScene big_scene() {
    BenchScene scene;
    scene.name = "big";
    add_room(scene, {5, 2.5f, 5}, 70, 0.06f);
    Triangles& out = scene.triangles;
    const glm::vec3 places[] = {{-2.6f, 1, -2.4f},    {0.2f, 0.9f, -2.8f}, {2.7f, 1.1f, -2.2f},
                                {-1.4f, 0.7f, -0.2f}, {1.5f, 0.8f, 0.1f},  {3.2f, 0.7f, 1.6f},
                                {-3.2f, 0.8f, 1.4f},  {0.1f, 3.4f, -1.5f}};
    float frequency = 2.5f;
    for (const glm::vec3& place : places) add_blob(out, place, 0.85f, 120, 0.22f, frequency += 0.6f);
    add_foliage(out, {-3.4f, 2.6f, -3.2f}, 1.2f, 8000, 1);
    add_foliage(out, {3.3f, 2.9f, -3.4f}, 1.1f, 8000, 2);
    scene.eye = {0.3f, 1.9f, 4.6f};
    scene.target = {0, 1.4f, -1};
    scene.yfov = 0.95f;
    return scene;
}

BenchScene load_scene(const std::string& path) {
    const Scene loaded = import_gltf(path).scene;
    BenchScene scene;
    scene.name = std::filesystem::path(path).stem().string();
    for (const Instance& instance : loaded.instances) {
        const Mesh& mesh = loaded.meshes[instance.mesh];
        for (const glm::uvec3& corners : mesh.triangles) {
            bvh::Triangle triangle;
            for (int k = 0; k < 3; ++k)
                triangle.vertices[k] =
                    glm::vec3(instance.to_world * glm::vec4(mesh.positions[corners[k]], 1));
            scene.triangles.push_back(triangle);
        }
    }
    const Camera camera = loaded.cameras.empty() ? framing_camera(loaded, 1) : loaded.cameras[loaded.camera];
    scene.eye = glm::vec3(camera.to_world[3]);
    scene.target = scene.eye - glm::vec3(camera.to_world[2]);
    scene.yfov = camera.yfov;
    const Bounds bounds = scene_bounds(loaded);
    const glm::vec3 size = bounds.upper - bounds.lower;
    scene.light_corner = bounds.lower + size * glm::vec3(0.4f, 1.5f, 0.4f);
    scene.light_u = {0.2f * size.x, 0, 0};
    scene.light_v = {0, 0, 0.2f * size.z};
    return scene;
}

} // namespace ajar::bench
