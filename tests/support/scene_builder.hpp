// Scenes built in memory, for tests whose answer is a formula: no files, no importer.
#pragma once

#include "scene/scene.hpp"

#include <cstdint>
#include <vector>

namespace ajar::test {

// Exactly Lambert's law in glTF's model: a dielectric without a specular lobe.
Material lambert(glm::vec3 albedo);
// Emits `radiance` (W/(m^2 sr)) from its front, reflects nothing.
Material emitter(glm::vec3 radiance);
// Lambertian and emitting at once.
Material glowing_lambert(glm::vec3 albedo, glm::vec3 radiance);
Material metal(glm::vec3 color, float roughness);
Material plastic(glm::vec3 color, float roughness);

// How a tessellated sphere's normals are laid out. `flat`: each facet its own, so that the body is exactly
// the convex polyhedron one sees. `smooth`: radial at every vertex; interpolated between them they are radial
// everywhere.
enum class Normals { flat, smooth };

class SceneBuilder {
  public:
    std::uint32_t material(Material material); // index for the calls below

    // One instance each. A quad's front is where cross(b - a, c - a) points; texture coordinates run from
    // (0, 0) at a to (1, 1) at c.
    void quad(glm::vec3 a, glm::vec3 b, glm::vec3 c, glm::vec3 d, std::uint32_t material);
    // A square of that half side, facing along the unit vector `normal`.
    void square(glm::vec3 center, glm::vec3 normal, float half_side, std::uint32_t material);
    void box(glm::vec3 lower, glm::vec3 upper, std::uint32_t material);  // seen from outside
    void room(glm::vec3 lower, glm::vec3 upper, std::uint32_t material); // seen from inside, closed
    // An icosahedron with its edges halved `subdivisions` times (20 * 4^subdivisions triangles).
    void sphere(glm::vec3 center, float radius, int subdivisions, Normals normals, std::uint32_t material);

    // A sphere() that emits as the sphere itself; the material's emission counts.
    void sphere_light(glm::vec3 center, float radius, std::uint32_t material);

    void point_light(glm::vec3 position, glm::vec3 intensity, float radius = 0);
    void spot_light(glm::vec3 position, glm::vec3 direction, glm::vec3 intensity, float inner, float outer,
                    float radius = 0);
    void directional_light(glm::vec3 direction, glm::vec3 irradiance, float angular_diameter = 0); // radians
    void constant_environment(glm::vec3 radiance);
    // radiance(direction) at the middle of each texel.
    template <class Radiance>
    void environment_map(std::uint32_t width, std::uint32_t height, Radiance&& radiance);

    // An RGBA8 image of the given texels, row 0 at the top, as a texture with that filter. Returns its index.
    std::uint32_t texture(std::uint32_t width, std::uint32_t height, std::vector<std::uint8_t> rgba,
                          TextureFilter filter);

    void perspective(glm::vec3 eye, glm::vec3 target, float yfov);  // radians
    void orthographic(glm::vec3 eye, glm::vec3 target, float ymag); // half the height, metres

    // Checks and hands out what was built.
    Scene build() const;

  private:
    void add(Mesh mesh, std::uint32_t material);

    Scene scene_;
};

// A unit direction through the middle of texel (i, j) of an equirectangular map, as Environment lays it out.
glm::vec3 environment_direction(std::uint32_t i, std::uint32_t j, std::uint32_t width, std::uint32_t height);

template <class Radiance>
void SceneBuilder::environment_map(std::uint32_t width, std::uint32_t height, Radiance&& radiance) {
    Environment environment;
    environment.name = "test";
    environment.width = width;
    environment.height = height;
    for (std::uint32_t j = 0; j < height; ++j)
        for (std::uint32_t i = 0; i < width; ++i)
            environment.radiance.push_back(radiance(environment_direction(i, j, width, height)));
    scene_.environment = std::move(environment);
}

} // namespace ajar::test
