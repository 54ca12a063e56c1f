// What pieces of surface emit and reflect, as the device's own materials have it.
#pragma once

#include "render/gpu_scene.hpp"
#include "render/render.hpp"
#include "shaders/shared/element.glsl.h"

#include <span>

namespace ajar {

// Of a scene all of whose instances are baked, by kernel average.
ElementMaterials average_materials(const gpu::Device& device, const GpuScene& scene,
                                   std::span<const shared::SurfaceElement> elements,
                                   const RenderSettings& settings);

} // namespace ajar
