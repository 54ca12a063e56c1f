#include "import/extensions/lights_punctual.hpp"

#include "import/extras.hpp"

#include <fmt/format.h>
#include <numbers>

namespace ajar::gltf {

namespace {

constexpr std::string_view NAME = "KHR_lights_punctual";

void read_spot(const JsonObject& object, Light& light) {
    const auto spot = object.object("spot");
    if (!spot) return;
    light.inner_cone_angle = spot->number("innerConeAngle", 0);
    light.outer_cone_angle = spot->number("outerConeAngle", std::numbers::pi_v<float> / 4);
    if (!(light.inner_cone_angle >= 0 && light.inner_cone_angle <= light.outer_cone_angle &&
          light.outer_cone_angle <= std::numbers::pi_v<float> / 2 + 1e-4f)) // pi/2 as exporters round it
        spot->fail("", fmt::format("the cone angles {} and {} must be 0 <= inner <= outer <= pi/2",
                                   light.inner_cone_angle, light.outer_cone_angle));
}

Light read_light(const JsonObject& object) {
    Light light;
    light.name = object.text("name");
    const std::string type = object.text("type");
    if (type == "directional")
        light.kind = LightKind::directional;
    else if (type == "spot")
        light.kind = LightKind::spot;
    else if (type != "point")
        object.fail("type", fmt::format("'{}' is none of point, spot, directional", type));
    const float intensity = object.number("intensity", 1);
    light.intensity =
        glm::max(object.vector<3>("color", glm::vec3(1)), glm::vec3(0)) * std::max(intensity, 0.0f);
    light.range = object.number("range", 0);
    if (light.range < 0) object.fail("range", "must not be negative");
    if (light.kind == LightKind::spot) read_spot(object, light);
    return light;
}

void read_extent(Document& document, const JsonObject& object, Light& light) {
    const std::string owner = fmt::format("light '{}'", light.name);
    constexpr float LARGEST = 1e9f; // metres
    if (light.kind == LightKind::directional)
        light.angular_diameter =
            glm::radians(extras_number(document, object, "angular_diameter_degrees", 180, owner).value_or(0));
    else
        light.radius = extras_number(document, object, "radius", LARGEST, owner).value_or(0);
}

} // namespace

void add_punctual_lights(Document& document, const Nodes& nodes, Scene& scene) {
    const auto extension = document.root().extension(NAME);
    const std::vector<JsonObject> lights =
        extension ? extension->objects("lights") : std::vector<JsonObject>{};
    document.info().lights = lights.size();
    for (const std::uint32_t node : nodes.in_scene()) {
        const auto use = nodes.object(node).extension(NAME);
        if (!use) continue;
        const auto index = use->index("light", lights.size(), "light");
        if (!index) use->fail("light", "is missing");
        Light light = read_light(lights[*index]);
        if (light.name.empty()) light.name = nodes.name(node);
        read_extent(document, lights[*index], light);
        const glm::mat4& to_world = nodes.to_world(node);
        light.position = glm::vec3(to_world[3]);
        const glm::vec3 forward = -glm::vec3(to_world[2]); // a light shines along its node's -Z
        light.direction = glm::length(forward) > 0 ? glm::normalize(forward) : glm::vec3(0, 0, -1);
        scene.lights.push_back(std::move(light));
    }
}

} // namespace ajar::gltf
