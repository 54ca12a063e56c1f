// The camera as generate reads it.
#pragma once

#include "render/settings.hpp"
#include "scene/scene.hpp"
#include "shaders/shared/frame.glsl.h"

namespace ajar {

// A camera by name or index; empty: the scene's own, or one that frames everything where the scene has none.
// Throws Error listing the cameras when there is no such one.
Camera choose_camera(const Scene& scene, const RenderSettings& settings);

// Sets the FrameRecord's camera fields for an image of that size. yfov and ymag hold, the width decides the
// rest.
void place_camera(const Camera& camera, std::uint32_t width, std::uint32_t height,
                  shared::FrameRecord& frame);

} // namespace ajar
