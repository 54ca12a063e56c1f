// The light that a scene without any light is given.
#pragma once

#include "scene/scene.hpp"

namespace ajar {

// A neutral studio: grey all around, brighter towards the top, with a broad soft light from the upper left
// front, so that shapes read and white objects stand out from the background. Mean radiance near 0.5.
Environment default_environment();

} // namespace ajar
