#include "render/camera.hpp"

#include "base/error.hpp"

#include <charconv>
#include <cmath>
#include <fmt/format.h>

namespace ajar {

Camera choose_camera(const Scene& scene, const RenderSettings& settings) {
    if (settings.camera.empty()) {
        if (scene.camera < scene.cameras.size()) return scene.cameras[scene.camera];
        return framing_camera(scene,
                              static_cast<float>(settings.width) / static_cast<float>(settings.height));
    }
    std::string known;
    for (const Camera& camera : scene.cameras) {
        if (camera.name == settings.camera) return camera;
        known += fmt::format("{}'{}'", known.empty() ? "" : ", ", camera.name);
    }
    std::size_t index = 0;
    const char* end = settings.camera.data() + settings.camera.size();
    const auto [rest, code] = std::from_chars(settings.camera.data(), end, index);
    if (code == std::errc() && rest == end && index < scene.cameras.size()) return scene.cameras[index];
    throw Error(
        fmt::format("camera '{}': the scene has {}{}", settings.camera,
                    scene.cameras.empty() ? "no camera" : "cameras 0 to ",
                    scene.cameras.empty() ? "" : fmt::format("{}: {}", scene.cameras.size() - 1, known)));
}

void place_camera(const Camera& camera, std::uint32_t width, std::uint32_t height,
                  shared::FrameRecord& frame) {
    const glm::mat4& m = camera.to_world;
    const float aspect = static_cast<float>(width) / static_cast<float>(height);
    const bool perspective = camera.kind == CameraKind::perspective;
    frame.camera_scale_y = perspective ? std::tan(0.5f * camera.yfov) : camera.ymag;
    frame.camera_scale_x = frame.camera_scale_y * aspect;
    frame.camera_right = glm::normalize(glm::vec3(m[0]));
    frame.camera_up = glm::normalize(glm::vec3(m[1]));
    frame.camera_back = glm::normalize(glm::vec3(m[2]));
    frame.camera_origin = glm::vec3(m[3]);
    frame.width = width;
    frame.height = height;
}

} // namespace ajar
