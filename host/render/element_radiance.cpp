#include "render/element_radiance.hpp"

#include "base/error.hpp"
#include "render/choices.hpp"
#include "render/render_job.hpp"
#include "shaders/shared/specialization.glsl.h"

#include <fmt/format.h>
#include <glm/gtc/constants.hpp>
#include <optional>

namespace ajar {

ElementRadiance trace_elements(const gpu::Device& device, const Scene& scene, const GpuScene& gpu_scene,
                               std::span<const shared::SurfaceElement> elements,
                               const RenderSettings& settings, const ProgressSink& progress) {
    if (!find_integrator(settings.integrator).from_surfaces)
        throw Error(fmt::format("integrator '{}': its paths begin at the camera alone (use path, direct or "
                                "ao)",
                                settings.integrator));
    if (elements.empty()) return {};
    RenderSettings used = settings;
    used.aovs = false;
    used.camera.clear();
    used.width = used.height = 1;
    // What is learned depends on where paths begin: it is of no use to others.
    std::optional<LearnedVisibility> visibility;
    if (learns_visibility(used)) visibility.emplace(device);
    RenderJob job(device, scene, gpu_scene, used, visibility ? &*visibility : nullptr, elements);
    const RenderOutput output = job.run(progress);

    ElementRadiance result;
    result.stats = output.stats;
    const float scale = used.integrator == "ao" ? 1.0f : glm::pi<float>();
    const std::vector<float>& mean = output.image.find("")->pixels;
    const std::vector<float>& variance = output.image.find("variance")->pixels;
    for (std::size_t i = 0; i < elements.size(); ++i) {
        result.irradiance.push_back(scale * glm::vec3(mean[4 * i], mean[4 * i + 1], mean[4 * i + 2]));
        result.variance.push_back(scale * scale *
                                  glm::vec3(variance[3 * i], variance[3 * i + 1], variance[3 * i + 2]));
    }
    return result;
}

} // namespace ajar
