// Integrator radiosity shows patches with made-up light, so that pixels have closed forms: what was solved is
// another test's business.
#include "base/error.hpp"
#include "radiosity/patch_mesh.hpp"
#include "render_test.hpp"
#include "support/statistics.hpp"

#include <bit>
#include <glm/gtc/constants.hpp>

namespace ajar::test {
namespace {

using shared::PatchSide;

constexpr double PI = glm::pi<double>();
const glm::vec3 ALBEDO(0.8f, 0.5f, 0.2f);
const glm::vec3 EMISSION(0.5f, 0.25f, 1);

// Made up by patch, and by corner's position.
using SideOf = std::function<PatchSide(const PatchMesh&, std::uint32_t patch, bool back)>;

PatchPicture picture_of(const PatchMesh& mesh, const SideOf& side) {
    PatchPicture picture{mesh.triangles(), mesh.nodes, {}};
    for (std::uint32_t p = 0; p < mesh.patches.size(); ++p)
        for (const bool back : {false, true}) picture.sides.push_back(side(mesh, p, back));
    return picture;
}

// The same everywhere.
SideOf uniform(glm::vec3 radiance, glm::vec3 irradiance) {
    return [=](const PatchMesh&, std::uint32_t, bool) {
        return PatchSide{radiance, {irradiance, irradiance, irradiance}};
    };
}

// A field linear in space, which corners hold exactly; the backs' is three times as strong.
glm::dvec3 field(const glm::dvec3& p) { return {2 + 0.2 * p.x, 3 - 0.1 * p.z + 0.1 * p.x, 1.5 + 0.4 * p.y}; }
SideOf linear_field() {
    return [](const PatchMesh& mesh, std::uint32_t patch, bool back) {
        PatchSide side{};
        for (int k = 0; k < 3; ++k)
            side.irradiance[k] =
                (back ? 3.0f : 1.0f) * glm::vec3(field(mesh.positions[mesh.patches[patch].vertices[k]]));
        return side;
    };
}

class Patches : public RenderTest {
  protected:
    static RenderSettings settings(const char* shading) {
        RenderSettings settings = small_settings();
        settings.integrator = "radiosity";
        settings.shading = shading;
        return settings;
    }
    static Image show(const Scene& scene, const RenderSettings& settings, const SideOf& side,
                      std::uint32_t patches = 300, const gpu::Device& on = device()) {
        Renderer renderer(on, scene, [](std::string_view line) { ADD_FAILURE() << line; });
        renderer.show(picture_of(PatchMesh::subdivide(scene, {0, patches}), side));
        RenderOutput output = renderer.render(settings);
        EXPECT_EQ(output.stats.invalid_samples + output.stats.exhausted_loops, 0u);
        return std::move(output.image);
    }
};

// A floor of Lambertian quads, the further one seen from behind.
Scene floor_scene(const Material& material) {
    SceneBuilder builder;
    const std::uint32_t m = builder.material(material);
    builder.quad({-9, 0, 9}, {9, 0, 9}, {9, 0, 0}, {-9, 0, 0}, m);
    builder.quad({-9, 0, -9}, {9, 0, -9}, {9, 0, 0}, {-9, 0, 0}, m);
    builder.perspective({0, 2, 4}, {0, 0, 0}, 0.7f);
    return builder.build();
}

// The field on the floor; none near the seam of its quads.
std::optional<glm::dvec3> floor_field(const ViewRay& ray) {
    if (ray.direction.y > -0.1) return std::nullopt;
    const glm::dvec3 p = meet_plane(ray, {0, 0, 0}, {0, 1, 0});
    if (std::abs(p.z) < 1e-3 || std::abs(p.x) > 8 || std::abs(p.z) > 8) return std::nullopt;
    return (p.z < 0 ? 3.0 : 1.0) * field(p);
}

TEST_F(Patches, SmoothIsIrradianceTimesReflectanceAndEmission) {
    Material material = glowing_lambert(ALBEDO, EMISSION);
    const Scene scene = floor_scene(material);
    RenderSettings s = settings("smooth");
    s.samples = 256;
    expect_radiance(
        show(scene, s, linear_field()), scene.cameras[0], s,
        [](const ViewRay& ray) {
            std::optional<glm::dvec3> e = floor_field(ray);
            if (!e) return e;
            const bool front = meet_plane(ray, {0, 0, 0}, {0, 1, 0}).z > 0; // emits there alone
            return std::optional(glm::dvec3(ALBEDO) / PI * *e + (front ? 1.0 : 0.0) * glm::dvec3(EMISSION));
        },
        1e-4); // barycentrics within small patches are floats
}

TEST_F(Patches, SmoothKeepsTexturesSharp) {
    Scene scene = floor_scene(lambert(glm::vec3(1)));
    // Black and white halves; the quads' texture coordinates run along x.
    scene.images.push_back({"", 2, 1, {0, 0, 0, 255, 255, 255, 255, 255}});
    Texture texture;
    texture.filter = TextureFilter::nearest;
    scene.textures.push_back(texture);
    scene.materials[0].base_color_texture.texture = 0;
    const RenderSettings s = settings("smooth");
    const Image image = show(scene, s, uniform({0, 0, 0}, glm::vec3(float(PI))), 8);
    std::size_t black = 0, white = 0;
    for (std::uint32_t y = 12; y < s.height; ++y)
        for (std::uint32_t x = 0; x < s.width; ++x) {
            const double value = pixel(image, "", x, y).x;
            black += value == 0;
            white += std::abs(value - 1) < 1e-5;
        }
    EXPECT_GT(black, 100u);
    EXPECT_GT(white, 100u);
    EXPECT_GT(black + white, s.width * (s.height - 12) * 9 / 10) << "hardly anything between";
}

TEST_F(Patches, FlatIsTheConstantOfThePatch) {
    const Scene scene = floor_scene(glowing_lambert(ALBEDO, EMISSION));
    RenderSettings s = settings("flat");
    s.filter_radius = 1e-3f; // rays through pixels' middles
    const PatchMesh mesh = PatchMesh::subdivide(scene, {0, 300});
    const auto constant = [](std::uint32_t patch, bool back) {
        return glm::vec3(1.0f + static_cast<float>(patch), back ? 1.0f : 2.0f, 0.5f);
    };
    const Image image = show(scene, s, [&](const PatchMesh&, std::uint32_t patch, bool back) {
        return PatchSide{constant(patch, back), {}};
    });
    std::size_t tested = 0;
    for (std::uint32_t y = 0; y < s.height; ++y)
        for (std::uint32_t x = 0; x < s.width; ++x) {
            const ViewRay ray = view_ray(scene.cameras[0], s, x + 0.5, y + 0.5);
            const glm::dvec3 p = meet_plane(ray, {0, 0, 0}, {0, 1, 0});
            if (ray.direction.y > -0.05 || std::abs(p.x) > 8 || std::abs(p.z) > 8) continue;
            for (std::uint32_t patch = 0; patch < mesh.patches.size(); ++patch) {
                const auto corner = [&](int k) {
                    return glm::dvec3(mesh.positions[mesh.patches[patch].vertices[k]]);
                };
                double least = INFINITY; // distance to the border, inwards
                for (int k = 0; k < 3; ++k) {
                    const glm::dvec3 edge = glm::normalize(corner((k + 1) % 3) - corner(k));
                    const glm::dvec3 inwards = glm::cross(glm::dvec3(mesh.patches[patch].normal), edge);
                    least = std::min(least, glm::dot(inwards, p - corner(k)));
                }
                if (least < 0.01) continue;
                ++tested;
                const glm::dvec3 expected = constant(patch, mesh.patches[patch].normal.y < 0);
                EXPECT_LT(glm::distance(pixel(image, "", x, y), expected), 1e-5 * expected.x)
                    << x << " " << y;
            }
        }
    EXPECT_GT(tested, s.width * s.height / 2);
}

// A closed room in which all walls reflect ALBEDO of a constant irradiance E and emit: a gather sees in every
// direction Le + rho / pi E, so that L = Le + rho (Le + rho / pi E).
TEST_F(Patches, GatherInAClosedRoom) {
    for (const char* strategy : {"mis", "light", "bsdf"}) {
        SceneBuilder builder;
        builder.room({-1, -1, -1}, {1, 1, 1}, builder.material(glowing_lambert(ALBEDO, EMISSION)));
        builder.perspective({0.3f, 0.2f, 0.9f}, {0, -0.2f, -1}, 1.2f);
        const Scene scene = builder.build();
        RenderSettings s = settings("gather");
        s.strategy = strategy;
        s.samples = 64;
        const glm::dvec3 irradiance(3, 4, 5);
        SCOPED_TRACE(strategy);
        expect_radiance(show(scene, s, uniform({7, 7, 7}, irradiance)), scene.cameras[0], s,
                        [&](const ViewRay&) -> std::optional<glm::dvec3> {
                            const glm::dvec3 le(EMISSION), rho(ALBEDO);
                            return le + rho * (le + rho / PI * irradiance);
                        });
    }
}

// Where patches send nothing, all that is left is direct light: by the same rays, hence the same bits.
TEST_F(Patches, GatherOfDarkPatchesIsDirectLight) {
    SceneBuilder builder;
    const std::uint32_t grey = builder.material(plastic(ALBEDO, 0.3f));
    builder.box({-0.5f, 0, -0.5f}, {0.5f, 1, 0.5f}, grey);
    builder.square({0, 0, 0}, {0, 1, 0}, 5, grey);
    builder.square({1, 3, 1}, {0, -1, 0}, 0.5f, builder.material(emitter({9, 8, 7})));
    builder.sphere_light({-2, 2, 1}, 0.3f, builder.material(emitter({5, 5, 9})));
    builder.point_light({2, 2, 2}, {3, 3, 3});
    builder.constant_environment({0.3f, 0.4f, 0.5f});
    builder.perspective({2, 2, 4}, {0, 0.5f, 0}, 0.7f);
    const Scene scene = builder.build();
    RenderSettings s = settings("gather");
    s.samples = 8;
    const Image gathered = show(scene, s, uniform({1, 1, 1}, {0, 0, 0}));
    s.integrator = "direct";
    s.bake_below_triangles = UINT64_MAX;
    EXPECT_EQ(beauty(gathered, "gather").pixels, beauty(render(scene, s), "direct").pixels);
}

void expect_same_bits(const Image& a, const Image& b) {
    const std::vector<float>& of_a = beauty(a, "a").pixels;
    const std::vector<float>& of_b = beauty(b, "b").pixels;
    ASSERT_EQ(of_a.size(), of_b.size());
    std::size_t different = 0;
    for (std::size_t i = 0; i < of_a.size(); ++i)
        different += std::bit_cast<std::uint32_t>(of_a[i]) != std::bit_cast<std::uint32_t>(of_b[i]);
    EXPECT_EQ(different, 0u);
}

TEST_F(Patches, AreTheSameBitsWhateverThePoolAndTheTables) {
    SceneBuilder builder;
    const std::uint32_t grey = builder.material(plastic(ALBEDO, 0.5f));
    builder.room({-1, -1, -1}, {1, 1, 1}, grey);
    builder.sphere({0, -0.5f, 0}, 0.4f, 2, Normals::smooth, grey);
    builder.square({0, 0.99f, 0}, {0, -1, 0}, 0.3f, builder.material(emitter({9, 9, 9})));
    builder.perspective({0, 0, 0.95f}, {0, -0.2f, -1}, 1.2f);
    const Scene scene = builder.build();
    for (const char* shading : {"flat", "smooth", "gather"}) {
        SCOPED_TRACE(shading);
        RenderSettings s = settings(shading);
        s.width = 37;
        s.samples = 6;
        const Image reference = show(scene, s, linear_field());
        s.pool_paths = 1000;
        s.segment_paths = 64;
        s.slice_seconds = 1e-6;
        expect_same_bits(reference, show(scene, s, linear_field()));
        gpu::DeviceOptions options;
        options.force_pointers = true;
        options.validation = true;
        options.on_validation = [](std::string_view message) { ADD_FAILURE() << message; };
        const gpu::Device other(options);
        expect_same_bits(reference, show(scene, s, linear_field(), 300, other));
    }
}

TEST_F(Patches, MustHaveBeenSolvedForFirst) {
    const Scene scene = floor_scene(lambert(ALBEDO));
    EXPECT_THROW(render(scene, settings("smooth")), Error);
    RenderSettings s = settings("smoth");
    EXPECT_THROW(show(scene, s, linear_field()), Error);
}

} // namespace
} // namespace ajar::test
