// A radiosity solution as integrator radiosity shows it.
#pragma once

#include "radiosity/radiosity.hpp"
#include "render/render.hpp"

namespace ajar {

PatchPicture patch_picture(const RadiositySolution& solution);

} // namespace ajar
