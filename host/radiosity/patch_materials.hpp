// What patches are made of: their emission and reflectance, by the path tracer's materials
// (shaders/kernels/average.glsl.h).
#pragma once

#include "base/events.hpp"
#include "gpu/buffer.hpp"
#include "radiosity/radiosity_rig.hpp"
#include "scene/scene.hpp"

#include <functional>

namespace ajar {

// Vectors by side, with SIDES_BESIDE zeroes behind.
struct PatchMaterials {
    explicit PatchMaterials(const RadiosityRig& rig);

    // False when `progress` (sides done) stopped it.
    bool average(RadiosityRig& rig, const std::function<bool(std::uint32_t)>& progress);

    gpu::Buffer emission;    // scalar: the share of the side that is there
    gpu::Buffer reflectance; // scalar: area that is there, m^2
};

// One line that names the materials of patches that do more than Lambert's law.
void warn_of_other_than_diffuse(const Scene& scene, const PatchMesh& mesh, const WarningSink& warn);

} // namespace ajar
