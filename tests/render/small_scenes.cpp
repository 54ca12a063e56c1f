#include "small_scenes.hpp"

#include "support/scene_builder.hpp"

namespace ajar::test {

namespace {

// A room open to the camera, with a large light in its ceiling.
std::uint32_t add_room(SceneBuilder& builder, glm::vec3 light) {
    const std::uint32_t white = builder.material(lambert({0.7f, 0.7f, 0.7f}));
    builder.square({0, 0, 0}, {0, 1, 0}, 1, white);
    builder.square({0, 1, -1}, {0, 0, 1}, 1, white);
    builder.square({-1, 1, 0}, {1, 0, 0}, 1, builder.material(lambert({0.7f, 0.1f, 0.1f})));
    builder.square({1, 1, 0}, {-1, 0, 0}, 1, builder.material(lambert({0.1f, 0.6f, 0.1f})));
    builder.square({0, 2, 0}, {0, -1, 0}, 0.6f, builder.material(emitter(light)));
    builder.perspective({0, 1, 4.5f}, {0, 0.95f, 0}, 0.45f);
    return white;
}

Scene diffuse_room() {
    SceneBuilder builder;
    const std::uint32_t white = add_room(builder, {6, 5, 4});
    builder.box({-0.6f, 0, -0.5f}, {0, 0.9f, 0.1f}, white);
    return builder.build();
}

Scene glossy_room() {
    SceneBuilder builder;
    add_room(builder, {6, 5, 4});
    builder.sphere({-0.4f, 0.4f, 0}, 0.4f, 3, Normals::smooth,
                   builder.material(metal({0.9f, 0.8f, 0.5f}, 0.35f)));
    builder.sphere({0.45f, 0.35f, 0.2f}, 0.35f, 3, Normals::smooth,
                   builder.material(plastic({0.2f, 0.3f, 0.7f}, 0.45f)));
    return builder.build();
}

Scene mirror_room() {
    SceneBuilder builder;
    add_room(builder, {6, 5, 4});
    builder.sphere({0, 0.5f, 0}, 0.45f, 3, Normals::smooth, builder.material(metal({0.9f, 0.9f, 0.9f}, 0)));
    return builder.build();
}

Scene sky() {
    SceneBuilder builder;
    builder.square({0, 0, 0}, {0, 1, 0}, 3, builder.material(lambert({0.5f, 0.5f, 0.5f})));
    builder.sphere({-0.5f, 0.45f, 0}, 0.45f, 3, Normals::smooth,
                   builder.material(plastic({0.6f, 0.3f, 0.2f}, 0.5f)));
    builder.sphere({0.5f, 0.45f, 0}, 0.45f, 3, Normals::smooth,
                   builder.material(metal({0.8f, 0.8f, 0.9f}, 0.5f)));
    builder.environment_map(64, 32, [](const glm::vec3& d) {
        const float glow = 8 * std::exp(8 * (glm::dot(d, glm::normalize(glm::vec3(1, 1, 0.5f))) - 1));
        return glm::vec3(0.3f, 0.4f, 0.6f) + glow * glm::vec3(1, 0.9f, 0.7f);
    });
    builder.perspective({0, 1.2f, 3.5f}, {0, 0.35f, 0}, 0.6f);
    return builder.build();
}

Scene textured_lights() {
    SceneBuilder builder;
    add_room(builder, {0, 0, 0});
    std::vector<std::uint8_t> texels;
    for (int i = 0; i < 16; ++i)
        for (const int channel : {1, 2, 4}) {
            texels.push_back(static_cast<std::uint8_t>((i * 37 * channel) % 256));
            if (channel == 4) texels.push_back(255);
        }
    Material panel = emitter({6, 6, 6});
    panel.emission_texture.texture = builder.texture(4, 4, texels, TextureFilter::linear);
    const std::uint32_t glowing = builder.material(panel);
    builder.square({0, 1.9f, 0}, {0, -1, 0}, 0.7f, glowing);
    panel.double_sided = true;
    builder.quad({-0.5f, 0.2f, 0}, {0.5f, 0.2f, 0.3f}, {0.5f, 1.2f, 0.3f}, {-0.5f, 1.2f, 0},
                 builder.material(panel));
    return builder.build();
}

// As large lights as the others, but many, and of very different power.
Scene many_lights() {
    SceneBuilder builder;
    const std::uint32_t white = add_room(builder, {1, 1, 1});
    for (int i = 0; i < 5; ++i)
        builder.square(
            {-0.8f + 0.4f * static_cast<float>(i), 1.2f, 0}, glm::normalize(glm::vec3(0, -1, 0.3f)), 0.15f,
            builder.material(emitter(glm::vec3(1 << i) * glm::vec3(1, 0.5f, 0.25f * static_cast<float>(i)))));
    builder.box({-0.3f, 0, -0.3f}, {0.3f, 0.5f, 0.3f}, white);
    return builder.build();
}

// Half transparent cards, one dithered by alpha and one cut out by a texture, between light and floor.
Scene cards() {
    SceneBuilder builder;
    add_room(builder, {6, 5, 4});
    Material veil = lambert({0.8f, 0.4f, 0.3f});
    veil.base_color.a = 0.4f;
    veil.alpha_mode = AlphaMode::blend;
    veil.double_sided = true;
    builder.square({-0.4f, 0.9f, 0}, {0, 1, 0}, 0.45f, builder.material(veil));
    const std::vector<std::uint8_t> texels = {90, 170, 60, 255, 90, 170, 60, 0,
                                              90, 170, 60, 60,  90, 170, 60, 255};
    Material leaf = lambert({1, 1, 1});
    leaf.base_color_texture.texture = builder.texture(2, 2, texels, TextureFilter::linear);
    leaf.alpha_mode = AlphaMode::mask;
    leaf.double_sided = true;
    builder.quad({0.1f, 0.2f, 0}, {0.9f, 0.2f, 0.3f}, {0.9f, 1.1f, 0.3f}, {0.1f, 1.1f, 0},
                 builder.material(leaf));
    return builder.build();
}

// Every kind of light at once, near and from far away.
Scene all_lights() {
    SceneBuilder builder;
    const std::uint32_t white = builder.material(lambert({0.7f, 0.7f, 0.7f}));
    builder.square({0, 0, 0}, {0, 1, 0}, 2, white);
    builder.square({0, 1, -1}, {0, 0, 1}, 1, white);
    builder.square({-0.8f, 0.9f, 0.2f}, glm::normalize(glm::vec3(1, -0.5f, 0)), 0.2f,
                   builder.material(emitter({4, 3, 2})));
    builder.box({-0.2f, 0, -0.2f}, {0.3f, 0.4f, 0.3f}, white);
    builder.constant_environment({0.2f, 0.3f, 0.5f});
    builder.perspective({0, 1, 3.2f}, {0, 0.5f, 0}, 0.7f);
    Scene scene = builder.build();
    Light light;
    light.position = {0.7f, 1.2f, 0.4f};
    light.intensity = glm::vec3(0.4f, 0.5f, 0.3f);
    scene.lights.push_back(light);
    light.kind = LightKind::spot;
    light.position = {-0.3f, 1.6f, 0.8f};
    light.direction = glm::normalize(glm::vec3(0.2f, -1, -0.4f));
    light.inner_cone_angle = 0.2f;
    light.outer_cone_angle = 0.5f;
    scene.lights.push_back(light);
    light.kind = LightKind::directional;
    light.intensity = glm::vec3(0.6f, 0.5f, 0.4f);
    scene.lights.push_back(light);
    return scene;
}

// Under lights of some extent.
void add_things(SceneBuilder& builder) {
    builder.square({0, 0, 0}, {0, 1, 0}, 3, builder.material(lambert({0.5f, 0.5f, 0.5f})));
    builder.sphere({-0.5f, 0.4f, 0}, 0.4f, 3, Normals::smooth,
                   builder.material(metal({0.9f, 0.8f, 0.5f}, 0.4f)));
    builder.sphere({0.5f, 0.4f, 0.2f}, 0.4f, 3, Normals::smooth,
                   builder.material(plastic({0.2f, 0.4f, 0.7f}, 0.45f)));
    builder.perspective({0, 1.2f, 3.5f}, {0, 0.35f, 0}, 0.6f);
}

// A lamp, a mesh that is a sphere and shows itself to the camera, and a lamp that one thing reaches into.
Scene sphere_lights() {
    SceneBuilder builder;
    add_things(builder);
    builder.point_light({-0.3f, 1.4f, 0.6f}, {1.5f, 1.2f, 0.8f}, 0.25f);
    builder.sphere_light({0.1f, 0.3f, 0.7f}, 0.2f,
                         builder.material(glowing_lambert({0.6f, 0.6f, 0.6f}, {2, 3, 4})));
    builder.point_light({-0.5f, 0.8f, 0.1f}, {0.1f, 0.2f, 0.1f}, 0.2f);
    return builder.build();
}

Scene soft_sun() {
    SceneBuilder builder;
    add_things(builder);
    builder.directional_light({-0.5f, -1, -0.4f}, {3, 2.8f, 2.5f}, 0.5f);
    builder.constant_environment({0.1f, 0.15f, 0.25f});
    return builder.build();
}

Scene spot_with_radius() {
    SceneBuilder builder;
    add_things(builder);
    builder.spot_light({0.4f, 1.6f, 0.9f}, {-0.3f, -1, -0.6f}, {4, 4, 3}, 0.3f, 0.7f, 0.3f);
    return builder.build();
}

// A map that is one light of two, dim but for a third of it, above a box with a mirror beside it.
Scene sky_and_lamp() {
    SceneBuilder builder;
    const std::uint32_t white = builder.material(lambert({0.6f, 0.6f, 0.6f}));
    builder.square({0, 0, 0}, {0, 1, 0}, 3, white);
    builder.box({-0.7f, 0, -0.3f}, {-0.1f, 0.5f, 0.3f}, white);
    builder.sphere({0.5f, 0.45f, 0}, 0.45f, 3, Normals::smooth,
                   builder.material(metal({0.9f, 0.9f, 0.9f}, 0)));
    builder.square({-0.4f, 1.4f, 0.4f}, {0, -1, 0}, 0.2f, builder.material(emitter({5, 4, 3})));
    builder.environment_map(32, 16, [](const glm::vec3& d) {
        return d.x > 0.4f ? glm::vec3(1.5f, 1.2f, 0.9f) : glm::vec3(0.2f, 0.25f, 0.4f);
    });
    builder.perspective({0, 1.2f, 3.5f}, {0, 0.35f, 0}, 0.6f);
    return builder.build();
}

constexpr SmallScene SCENES[] = {
    {"DiffuseRoom", diffuse_room, true},
    {"GlossyRoom", glossy_room, true},
    {"MirrorRoom", mirror_room, false},
    {"Sky", sky, true},
    {"TexturedLights", textured_lights, true},
    {"ManyLights", many_lights, true},
    {"Cards", cards, true},
    {"AllLights", all_lights, true},
    {"SphereLights", sphere_lights, true},
    {"SoftSun", soft_sun, true},
    {"SpotWithRadius", spot_with_radius, true},
    {"SkyAndLamp", sky_and_lamp, false},
};

} // namespace

std::span<const SmallScene> small_scenes() { return SCENES; }

} // namespace ajar::test
