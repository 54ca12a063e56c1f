#include "import/cameras.hpp"

#include <fmt/format.h>
#include <numbers>

namespace ajar::gltf {

namespace {

// Direction and up stay what the node makes of them; scale and shear, which a camera has no use for, go.
glm::mat4 rigid(const glm::mat4& m) {
    glm::vec3 back(m[2]);
    back = glm::length(back) > 0 ? glm::normalize(back) : glm::vec3(0, 0, 1);
    glm::vec3 up = glm::vec3(m[1]) - glm::dot(glm::vec3(m[1]), back) * back;
    if (!(glm::length(up) > 0)) up = std::abs(back.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
    const glm::vec3 right = glm::normalize(glm::cross(up, back));
    return {glm::vec4(right, 0), glm::vec4(glm::cross(back, right), 0), glm::vec4(back, 0), m[3]};
}

float positive(const JsonObject& object, std::string_view key, float limit) {
    const float value = object.number(key, 0);
    if (!(value > 0 && value < limit))
        object.fail(key, fmt::format("must be more than 0{}, is {}",
                                     std::isfinite(limit) ? " and less than pi" : "", value));
    return value;
}

Camera read_camera(const JsonObject& object) {
    Camera camera;
    camera.name = object.text("name");
    const std::string type = object.text("type");
    const auto lens = object.object(type == "orthographic" ? "orthographic" : "perspective");
    if (type != "orthographic" && type != "perspective")
        object.fail("type", fmt::format("'{}' is neither perspective nor orthographic", type));
    if (!lens) object.fail(type, "is missing");
    if (type == "orthographic") {
        camera.kind = CameraKind::orthographic;
        camera.ymag = std::abs(lens->number("ymag", 0)); // some exporters write the sign of a flip
        if (camera.ymag == 0) lens->fail("ymag", "must not be 0");
    } else {
        camera.yfov = positive(*lens, "yfov", std::numbers::pi_v<float>);
    }
    return camera;
}

} // namespace

void add_cameras(Document& document, const Nodes& nodes, Scene& scene) {
    const std::vector<JsonObject> cameras = document.root().objects("cameras");
    document.info().cameras = cameras.size();
    for (const std::uint32_t node : nodes.in_scene()) {
        const auto index = nodes.object(node).index("camera", cameras.size(), "camera");
        if (!index) continue;
        Camera camera = read_camera(cameras[*index]);
        if (camera.name.empty()) camera.name = nodes.name(node);
        camera.to_world = rigid(nodes.to_world(node));
        scene.cameras.push_back(std::move(camera));
    }
    document.info().automatic_camera = scene.cameras.empty();
    if (scene.cameras.empty()) scene.cameras.push_back(framing_camera(scene, document.options().aspect));
}

} // namespace ajar::gltf
