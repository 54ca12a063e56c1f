#include "radiosity/mesh_solution.hpp"

#include "base/clock.hpp"
#include "base/error.hpp"
#include "radiosity/reciprocity.hpp"
#include "radiosity/solvers.hpp"
#include "render/element_radiance.hpp"
#include "render/luminance.hpp"
#include "shaders/shared/radiosity.glsl.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <glm/gtc/constants.hpp>

namespace ajar {

using namespace shared;

namespace {

constexpr float PI = glm::pi<float>();
constexpr std::uint32_t RECIPROCITY_ROWS = 256;

constexpr Choice DIRECTS[] = {
    {"shadow-rays", "light straight from luminaires by shadow rays, reflections by form factors"},
    {"form-factors", "what patches emit by form factors as well; shadow rays to all other lights"},
};

glm::vec3 times_rho_over_pi(const glm::vec3& irradiance, const glm::vec3& reflectance) {
    return reflectance * irradiance * (1 / PI);
}

} // namespace

std::span<const Choice> radiosity_directs() { return DIRECTS; }

DirectLight find_radiosity_direct(std::string_view name) {
    if (name == DIRECTS[0].name) return DirectLight::shadow_rays;
    if (name == DIRECTS[1].name) return DirectLight::form_factors;
    throw Error(fmt::format("direct light '{}': there is none of that name (there are: {}, {})", name,
                            DIRECTS[0].name, DIRECTS[1].name));
}

MeshSolver::MeshSolver(const gpu::Device& device, const Scene& scene, const GpuScene& lit,
                       const GpuScene* dark, const RadiositySettings& settings, RadiositySolution& solution)
    : device_(device), scene_(scene), lit_(lit), dark_(dark), settings_(settings),
      direct_(find_radiosity_direct(settings.direct)), solution_(solution),
      rig_(device, scene, lit, solution.mesh, settings.render, settings.rays), materials_(rig_),
      factors_(rig_, settings.rays, settings.memory_bytes) {
    const std::size_t sides = rig_.side_count();
    for (std::vector<glm::vec3>* vector : {&solution.emission, &solution.reflectance, &solution.irradiance,
                                           &solution.radiance, &direct_light_})
        vector->assign(sides, glm::vec3(0));
    solution.active.assign(sides, 0);
    areas_.assign(sides, 0);
}

void MeshSolver::solve(std::uint32_t mesh, const ProgressSink& progress) {
    RadiosityStats& stats = solution_.stats;
    stats.device_bytes = 0;
    stats.interrupted =
        !average_materials(progress) || !trace_form_factors(progress) || !trace_direct_light(progress);
    if (!stats.interrupted) {
        solve_system(mesh, progress);
    } else {
        for (std::size_t side = 0; side < areas_.size(); ++side) {
            const glm::vec3 direct = direct_light_[side];
            solution_.irradiance[side] = direct;
            solution_.radiance[side] =
                solution_.emission[side] + times_rho_over_pi(direct, solution_.reflectance[side]);
        }
    }
    fill_stats();
}

bool MeshSolver::average_materials(const ProgressSink& progress) {
    const Clock::time_point start = Clock::now();
    const bool done = materials_.average(rig_, [&](std::uint32_t sides) {
        return progress({"materials", sides, rig_.side_count(), seconds_since(start)});
    });
    const std::vector<SideValue> emission = materials_.emission.read<SideValue>(0, rig_.side_count());
    const std::vector<SideValue> reflectance = materials_.reflectance.read<SideValue>(0, rig_.side_count());
    for (std::uint32_t side = 0; side < rig_.side_count(); ++side) {
        solution_.emission[side] = solution_.radiance[side] = emission[side].rgb;
        solution_.reflectance[side] = reflectance[side].rgb;
        areas_[side] = reflectance[side].scalar;
    }
    solution_.stats.material_seconds += seconds_since(start);
    return done;
}

// All fronts, and both sides of what has two; then every back that one of their rays meets.
bool MeshSolver::trace_form_factors(const ProgressSink& progress) {
    const Clock::time_point start = Clock::now();
    const PatchMesh& mesh = solution_.mesh;
    std::vector<std::uint32_t> sides;
    for (std::uint32_t side = 0; side < rig_.side_count(); ++side) {
        const PatchSource& source = mesh.sources[mesh.patches[side / 2].source];
        if (side % 2 == PATCH_FRONT || scene_.materials[source.material].double_sided) sides.push_back(side);
    }
    const bool done = factors_.trace(sides, [&](std::uint32_t rows, std::uint32_t total) {
        return progress({"form factors", rows, total, seconds_since(start)});
    });
    for (const std::uint32_t side : factors_.row_sides()) solution_.active[side] = 1;
    solution_.stats.form_factor_seconds += seconds_since(start);
    return done;
}

bool MeshSolver::trace_direct_light(const ProgressSink& progress) {
    const Clock::time_point start = Clock::now();
    const GpuScene* lights = direct_ == DirectLight::shadow_rays ? &lit_ : dark_;
    if (lights == nullptr) return true;
    std::vector<SurfaceElement> elements;
    for (const std::uint32_t side : factors_.row_sides()) elements.push_back(rig_.elements[side]);
    RenderSettings settings = settings_.render;
    settings.integrator = "direct";
    settings.samples = settings_.shadow_samples;
    settings.first_sample = settings.sequence_samples = 0;
    settings.time_limit = 0;
    settings.clamp = 0;
    const ElementRadiance light =
        trace_elements(device_, scene_, *lights, elements, settings, [&](const Progress& p) {
            return progress({"direct light", p.done, p.total, p.seconds});
        });
    for (std::size_t row = 0; row < elements.size(); ++row)
        direct_light_[factors_.row_sides()[row]] = light.irradiance[row];
    solution_.stats.invalid_samples = light.stats.invalid_samples;
    solution_.stats.direct_seconds += seconds_since(start);
    return !light.stats.interrupted;
}

// Unknown: what is reflected, or, where patches' own light goes through the matrix, all that leaves.
void MeshSolver::solve_system(std::uint32_t mesh, const ProgressSink& progress) {
    const Clock::time_point start = Clock::now();
    LinearSystem system(rig_, factors_, materials_);
    std::vector<glm::vec3> source(rig_.side_count(), glm::vec3(0));
    SolverLimits limits{settings_.tolerance, settings_.max_iterations, 0};
    for (const std::uint32_t side : factors_.row_sides()) {
        const glm::vec3& rho = solution_.reflectance[side];
        source[side] = times_rho_over_pi(direct_light_[side], rho);
        if (direct_ == DirectLight::form_factors) source[side] += solution_.emission[side];
        limits.max_reflectance = std::max<double>({limits.max_reflectance, rho.x, rho.y, rho.z});
    }
    system.begin(source);
    // Thousandths of the way from the first error to the tolerance, which errors go in equal steps of their
    // logarithm.
    constexpr std::uint64_t WHOLE = 1000;
    double first_error = 0;
    Progress now{"solve", 0, WHOLE, 0};
    const auto keep_going = [&] {
        now.seconds = seconds_since(start);
        return progress(now);
    };
    const auto record = [&](const RadiosityIteration& it) {
        solution_.history.push_back(it);
        solution_.history.back().mesh = mesh;
        if (first_error == 0 && std::isfinite(it.error)) first_error = it.error;
        if (it.error <= settings_.tolerance)
            now.done = WHOLE;
        else if (std::isfinite(it.error) && first_error > settings_.tolerance)
            now.done = std::max(
                now.done, static_cast<std::uint64_t>(WHOLE * std::max(std::log(first_error / it.error), 0.0) /
                                                     std::log(first_error / settings_.tolerance)));
        return keep_going();
    };
    const SolverEnd end = ajar::solve_system(
        system, factors_.row_count(), find_radiosity_solver(settings_.solver), limits, record, keep_going);
    solution_.stats.converged = end.converged;
    solution_.stats.iterations = end.iterations;
    finish(system, end.stopped, progress);
    solution_.stats.device_bytes = system.device_bytes();
    solution_.stats.solve_seconds += seconds_since(start);
}

// What has not been shot yet, as if it were spread evenly over all surfaces (Cohen et al. 1988): better to
// look at than its absence.
glm::vec3 MeshSolver::ambient(LinearSystem& system) const {
    if (settings_.solver != "shooting") return glm::vec3(0);
    const std::vector<glm::vec3> rest = system.rest();
    glm::dvec3 unshot(0);
    glm::dvec3 reflected(0);
    double area = 0;
    for (const std::uint32_t side : factors_.row_sides()) {
        area += areas_[side];
        unshot += static_cast<double>(areas_[side]) * glm::dvec3(rest[side]);
        reflected += static_cast<double>(areas_[side]) * glm::dvec3(solution_.reflectance[side]);
    }
    if (!(area > 0)) return glm::vec3(0);
    const glm::dvec3 mean_reflectance = glm::min(reflected / area, glm::dvec3(0.99)); // some is absorbed
    return glm::vec3(unshot / area / (1.0 - mean_reflectance));
}

void MeshSolver::finish(LinearSystem& system, bool stopped, const ProgressSink& progress) {
    RadiosityStats& stats = solution_.stats;
    const std::vector<glm::vec3> x = system.solution();
    std::vector<glm::vec3> received;
    std::vector<float> lost;
    const bool through_matrix = direct_ == DirectLight::form_factors;
    stats.interrupted = stopped || !system.receive_solution(received, lost, [&] {
        return progress({"solve", 1000, 1000, 0});
    });
    const glm::vec3 missing = stats.interrupted ? ambient(system) : glm::vec3(0);
    glm::dvec3 in(0), absorbed(0), escaped(0);
    for (const std::uint32_t side : factors_.row_sides()) {
        const glm::vec3& rho = solution_.reflectance[side];
        const glm::vec3& emission = solution_.emission[side];
        const glm::vec3 own = through_matrix ? emission : glm::vec3(0);
        glm::vec3& irradiance = solution_.irradiance[side];
        if (!stats.interrupted) {
            irradiance = direct_light_[side] + PI * received[side];
            const double area = areas_[side];
            in += area * glm::dvec3(PI * own + direct_light_[side]);
            absorbed += area * glm::dvec3((1.0f - rho) * irradiance);
            escaped += area * PI * lost[side] * glm::dvec3(x[side]);
        } else {
            for (int c = 0; c < 3; ++c)
                irradiance[c] = rho[c] > 0 ? PI * ((x[side][c] - own[c]) / rho[c] + missing[c])
                                           : direct_light_[side][c] + PI * missing[c];
        }
        solution_.radiance[side] = emission + times_rho_over_pi(irradiance, rho);
    }
    stats.power_in = luminance(in);
    stats.power_absorbed = luminance(absorbed);
    stats.power_escaped = luminance(escaped);
    if (stats.interrupted) return;
    const Reciprocity reciprocity = measure_reciprocity(rig_, factors_, RECIPROCITY_ROWS);
    stats.reciprocity_rms = reciprocity.rms;
    stats.reciprocity_expected = reciprocity.expected;
    stats.reciprocity_max = reciprocity.max;
    stats.reciprocity_pairs = reciprocity.pairs;
}

void MeshSolver::fill_stats() {
    RadiosityStats& stats = solution_.stats;
    stats.patches = solution_.mesh.patches.size();
    stats.sides = factors_.row_count();
    stats.rows_stored = factors_.stored_rows();
    stats.row_bytes = factors_.row_bytes();
    stats.device_bytes += rig_.device_bytes() + factors_.device_bytes() + lit_.device_bytes() +
                          (dark_ != nullptr ? dark_->device_bytes() : 0) + materials_.emission.size_bytes() +
                          materials_.reflectance.size_bytes();
    stats.form_factor_rays += factors_.rays_traced();
    stats.sky_share = factors_.sky_share();
    stats.nowhere_share = factors_.nowhere_share();
    stats.exhausted_loops += factors_.exhausted_loops();
}

} // namespace ajar
