// Radiosity: the light of a scene of diffuse surfaces by finite elements. With patches i of constant radiance
//   L_i = E_i + rho_i (H_i / pi + sum over j of F_ij L_j)
// where F_ij is the share of what leaves i that arrives at j (Goral et al. 1984, "Modeling the Interaction of
// Light Between Diffuse Surfaces"). host/radiosity/README.md says how each part is done.
#pragma once

#include "base/events.hpp"
#include "gpu/device.hpp"
#include "radiosity/patch_mesh.hpp"
#include "radiosity/settings.hpp"
#include "render/render.hpp"
#include "scene/scene.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace ajar {

// Rows that --help prints; solve_radiosity accepts exactly the names in them.
std::span<const Choice> radiosity_solvers();
std::span<const Choice> radiosity_directs();

// All vectors by side: 2 * patch + PATCH_FRONT or PATCH_BACK.
struct RadiositySolution {
    PatchMesh mesh;
    std::vector<glm::vec3> emission;    // W/(m^2 sr)
    std::vector<glm::vec3> reflectance; // rho, 0 to 1
    std::vector<glm::vec3> irradiance;  // W/m^2: all that arrives, straight and by reflection
    std::vector<glm::vec3> radiance;    // W/(m^2 sr): emission + rho / pi irradiance
    // 0: a back of a single-sided surface that no ray met. It has no row: nobody sees it, irradiance is 0.
    std::vector<std::uint8_t> active;
    std::vector<RadiosityIteration> history;
    RadiosityStats stats;
};

// progress: stages "materials", "form factors", "direct light", "solve"; return false to stop: what is known
// so far is then the solution. Warns about materials that are taken for diffuse, and where nothing converges.
// Throws Error: bad settings, a scene that is not valid or without any patch, device lost.
RadiositySolution solve_radiosity(const gpu::Device& device, const Scene& scene,
                                  const RadiositySettings& settings, const ProgressSink& progress = {},
                                  const WarningSink& warn = {});

} // namespace ajar
