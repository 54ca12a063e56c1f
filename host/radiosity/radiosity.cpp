#include "radiosity/radiosity.hpp"

#include "base/clock.hpp"
#include "base/error.hpp"
#include "radiosity/mesh_solution.hpp"
#include "radiosity/refinement.hpp"
#include "radiosity/solvers.hpp"

#include <algorithm>
#include <bit>
#include <fmt/format.h>
#include <optional>

namespace ajar {

namespace {

void check(const RadiositySettings& s) {
    if (!(s.patches.patch_size > 0) && s.patches.patches == 0)
        throw Error("radiosity: neither a patch size nor a number of patches (give one)");
    if (!std::has_single_bit(s.rays) || s.rays < 4 || s.rays > 65536)
        throw Error(fmt::format("form factor rays {}: must be a power of two from 4 to 65536", s.rays));
    if (s.shadow_samples == 0) throw Error("shadow samples: must be at least 1");
    if (!(s.tolerance > 0) || s.tolerance >= 1)
        throw Error(fmt::format("tolerance {}: must be above 0 and below 1", s.tolerance));
    if (s.max_iterations == 0) throw Error("iterations: must be at least 1");
    if (s.refine > 16) throw Error(fmt::format("refine {}: at most 16 times", s.refine));
    if (!(s.refine_threshold > 0)) throw Error("refinement threshold: must be above 0");
    if (!(s.render.slice_seconds > 0)) throw Error("slice: must be a positive time");
    find_radiosity_solver(s.solver);
    find_radiosity_direct(s.direct);
}

bool any_other_light(const Scene& scene, const RadiositySettings& settings) {
    const float* background = settings.render.background;
    const bool sky = scene.environment || background[0] > 0 || background[1] > 0 || background[2] > 0;
    const bool sphere = std::any_of(scene.instances.begin(), scene.instances.end(),
                                    [](const Instance& i) { return i.sphere_radius > 0; });
    return sky || sphere || !scene.lights.empty();
}

} // namespace

RadiositySolution solve_radiosity(const gpu::Device& device, const Scene& scene,
                                  const RadiositySettings& settings, const ProgressSink& progress,
                                  const WarningSink& warn) {
    const Clock::time_point start = Clock::now();
    check(settings);
    validate(scene);
    RadiositySolution solution;
    solution.stats.settings = settings;
    solution.mesh = PatchMesh::subdivide(scene, settings.patches);
    if (solution.mesh.patches.empty())
        throw Error("radiosity: the scene has no triangle with an area (there is nothing to solve for)");
    warn_of_other_than_diffuse(scene, solution.mesh, warn);

    GpuSceneOptions options;
    options.cull_backfaces = settings.render.cull_backfaces;
    const float* background = settings.render.background;
    options.background = glm::vec3(background[0], background[1], background[2]);
    options.bake_below_triangles = UINT64_MAX;
    const GpuScene lit(device, scene, options);
    // Luminaires that are no patches, for those who send the patches' own light through the matrix.
    const bool by_shadow_rays = find_radiosity_direct(settings.direct) == DirectLight::shadow_rays;
    std::optional<GpuScene> dark;
    options.dark_triangles = true;
    if (!by_shadow_rays && any_other_light(scene, settings)) dark.emplace(device, scene, options);
    solution.stats.prepare_seconds = seconds_since(start);

    for (std::uint32_t mesh = 0;; ++mesh) {
        MeshSolver solver(device, scene, lit, dark ? &*dark : nullptr, settings, solution);
        solver.solve(
            mesh, progress ? progress : [](const Progress&) { return true; });
        if (solution.stats.interrupted || mesh == settings.refine) break;
        const std::vector<std::uint8_t> marked = mark_gradients(solution, settings.refine_threshold);
        if (std::find(marked.begin(), marked.end(), 1) == marked.end()) break;
        solution.mesh.refine(marked);
    }
    const RadiosityStats& stats = solution.stats;
    if (warn && !stats.converged && !stats.interrupted)
        warn(fmt::format(
            "radiosity did not converge in {} iterations: the last changed values by {:.2g} of the "
            "greatest (a closed room that absorbs nothing never does)",
            stats.iterations, solution.history.back().residual));
    return solution;
}

} // namespace ajar
