// The solution on one mesh of patches, step by step: what they are made of, form factors, direct light, the
// system.
#pragma once

#include "radiosity/linear_system.hpp"
#include "radiosity/radiosity.hpp"

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace ajar {

enum class DirectLight { shadow_rays, form_factors };
DirectLight find_radiosity_direct(std::string_view name); // Error that lists the names

class MeshSolver {
  public:
    // `dark`: the scene with luminaires that are no patches alone, for DirectLight::form_factors; none: there
    // are none. Solves for solution.mesh, into `solution`.
    MeshSolver(const gpu::Device& device, const Scene& scene, const GpuScene& lit, const GpuScene* dark,
               const RadiositySettings& settings, RadiositySolution& solution);

    // `mesh`: how many times it was refined. Adds to the solution's history and seconds.
    void solve(std::uint32_t mesh, const ProgressSink& progress);

  private:
    bool average_materials(const ProgressSink& progress);
    bool trace_form_factors(const ProgressSink& progress);
    bool trace_direct_light(const ProgressSink& progress);
    void solve_system(std::uint32_t mesh, const ProgressSink& progress);
    void finish(LinearSystem& system, bool stopped, const ProgressSink& progress);
    glm::vec3 ambient(LinearSystem& system) const;
    void fill_stats();

    const gpu::Device& device_;
    const Scene& scene_;
    const GpuScene& lit_;
    const GpuScene* dark_;
    const RadiositySettings& settings_;
    const DirectLight direct_;
    RadiositySolution& solution_;
    RadiosityRig rig_;
    PatchMaterials materials_;
    FormFactors factors_;
    std::vector<float> areas_;            // that are there, m^2, by side
    std::vector<glm::vec3> direct_light_; // H, by side, W/m^2
};

} // namespace ajar
