// Light on surface elements (Renderer::irradiance) for those who hold a scene on a device themselves.
#pragma once

#include "render/gpu_scene.hpp"
#include "render/render.hpp"
#include "shaders/shared/element.glsl.h"

#include <span>

namespace ajar {

// `gpu_scene` must have all its instances baked. Settings as Renderer::irradiance takes them.
ElementRadiance trace_elements(const gpu::Device& device, const Scene& scene, const GpuScene& gpu_scene,
                               std::span<const shared::SurfaceElement> elements,
                               const RenderSettings& settings, const ProgressSink& progress);

} // namespace ajar
