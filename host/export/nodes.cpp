#include "export/nodes.hpp"

#include "export/materials.hpp"
#include "export/placement.hpp"

#include <cmath>

namespace ajar::gltf_out {

namespace {

constexpr const char* LIGHTS = "KHR_lights_punctual";

// A light shines along its node's -Z.
glm::mat4 light_place(const Light& light) {
    const glm::vec3 back = -light.direction;
    const glm::vec3 aside = std::abs(back.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
    const glm::vec3 x = glm::normalize(glm::cross(aside, back));
    return {glm::vec4(x, 0), glm::vec4(glm::cross(back, x), 0), glm::vec4(back, 0),
            glm::vec4(light.position, 1)};
}

Json light_json(const Light& light) {
    static constexpr const char* TYPES[] = {"point", "spot", "directional"};
    Json json;
    set_name(json, light.name);
    json["type"] = TYPES[static_cast<std::size_t>(light.kind)];
    const ScaledColor scaled = scaled_color(light.intensity);
    json["color"] = numbers(scaled.color);
    json["intensity"] = scaled.factor;
    if (light.range > 0) json["range"] = light.range;
    if (light.kind == LightKind::spot) {
        // The extension wants the inner angle below the outer one.
        json["spot"]["innerConeAngle"] =
            std::min(light.inner_cone_angle, std::nextafter(light.outer_cone_angle, 0.0f));
        json["spot"]["outerConeAngle"] = light.outer_cone_angle;
    }
    if (light.kind == LightKind::directional && light.angular_diameter > 0)
        json["extras"]["angular_diameter_degrees"] = glm::degrees(light.angular_diameter);
    if (light.kind != LightKind::directional && light.radius > 0) json["extras"]["radius"] = light.radius;
    return json;
}

// glTF wants planes that a path tracer does not know: everything farther than a hair is seen.
Json camera_json(const Camera& camera, float far_plane) {
    Json json;
    set_name(json, camera.name);
    if (camera.kind == CameraKind::perspective) {
        json["type"] = "perspective";
        json["perspective"] = {{"yfov", camera.yfov}, {"znear", far_plane * 1e-5f}};
    } else {
        json["type"] = "orthographic";
        json["orthographic"] = {
            {"xmag", camera.ymag}, {"ymag", camera.ymag}, {"znear", 0}, {"zfar", far_plane}};
    }
    return json;
}

// Beyond everything as seen from `eye`.
float far_plane(const Bounds& bounds, const glm::vec3& eye) {
    if (bounds.empty()) return 100;
    const glm::vec3 reach = glm::max(glm::abs(bounds.lower - eye), glm::abs(bounds.upper - eye));
    return std::max(2 * glm::length(reach), 1e-3f);
}

} // namespace

void add_instances(const Scene& scene, const std::vector<std::uint32_t>& meshes, Document& document) {
    for (const Instance& instance : scene.instances) {
        if (meshes[instance.mesh] == NO_INDEX) continue;
        Json node;
        set_name(node, instance.name);
        node["mesh"] = meshes[instance.mesh];
        if (instance.sphere_radius > 0) node["extras"]["ajar_sphere"] = true;
        place(document, std::move(node), instance.to_world);
    }
}

void add_lights(const Scene& scene, Document& document) {
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        const Light& light = scene.lights[i];
        document.uses(LIGHTS);
        document.root()["extensions"][LIGHTS]["lights"].push_back(light_json(light));
        Json node;
        set_name(node, light.name);
        node["extensions"][LIGHTS]["light"] = i;
        place(document, std::move(node), light_place(light));
    }
}

void add_cameras(const Scene& scene, Document& document) {
    const Bounds bounds = scene_bounds(scene);
    for (const Camera& camera : scene.cameras) {
        Json node;
        set_name(node, camera.name);
        node["camera"] =
            document.push("cameras", camera_json(camera, far_plane(bounds, glm::vec3(camera.to_world[3]))));
        place(document, std::move(node), camera.to_world);
    }
}

} // namespace ajar::gltf_out
