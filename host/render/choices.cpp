// The tables behind the options that choose a method: --integrator, --strategy, --light-sampler and others.
#include "render/choices.hpp"

#include "base/error.hpp"
#include "render/integrator.hpp"
#include "shaders/kernels/naive.glsl.h"
#include "shaders/kernels/shade.glsl.h"
#include "shaders/shared/frame.glsl.h"
#include "shaders/shared/specialization.glsl.h"

#include <array>
#include <fmt/format.h>
#include <iterator>

namespace ajar {

namespace {

constexpr IntegratorRow INTEGRATORS[] = {
    {{"path", "path tracing with direct lighting: shadow rays and multiple importance sampling"},
     make_path_integrator,
     true},
    {{"direct", "emission and light that arrives straight from luminaires: path without indirect bounces"},
     make_path_integrator,
     true},
    {{"naive", "path tracing without shadow rays: lights are found by chance"}, make_naive_integrator},
    {{"normals", "shading normals as colours"}, make_normals_integrator},
    {{"albedo", "reflectance of what the camera sees"}, make_albedo_integrator},
    {{"ao", "ambient occlusion within a distance"}, make_ao_integrator, true},
    {.choice = {"radiosity", "finite elements: what `ajar radiosity` solves, shown by --shading"},
     .make = make_patch_integrator,
     .shows_patches = true},
};

struct ConstantRow {
    Choice choice;
    std::uint32_t constant; // what the kernels are specialised with
};

// What choose_triangle_sampling makes of them is a feature bit.
constexpr std::uint32_t TRIANGLES_AS_THEY_ARE = 0;
constexpr std::uint32_t TRIANGLES_WIDE = 1;
constexpr std::uint32_t TRIANGLES_SMALL = 2;

// What choose_environment_sampling makes of them is an EnvironmentDensity.
constexpr std::uint32_t ENVIRONMENT_BY_STRATEGY = 0;
constexpr std::uint32_t ENVIRONMENT_RADIANCE = 1;
constexpr std::uint32_t ENVIRONMENT_COMPENSATED = 2;

constexpr ConstantRow STRATEGIES[] = {
    {{"mis", "both, combined by multiple importance sampling"}, shared::STRATEGY_MIS},
    {{"light", "shadow rays alone: mirrors still see lights directly"}, shared::STRATEGY_LIGHT},
    {{"bsdf", "BSDF sampling alone: lights without extent are not seen"}, shared::STRATEGY_BSDF},
};

constexpr ConstantRow HEURISTICS[] = {
    {{"power", "squares of densities"}, shared::HEURISTIC_POWER},
    {{"balance", "the densities themselves"}, shared::HEURISTIC_BALANCE},
};

constexpr ConstantRow LIGHT_RAYS[] = {
    {{"one", "to a light that the light sampler picks"}, shared::SHADE_WHOLE},
    {{"all", "to every light, of which there may be 256"}, shared::SHADE_LIGHT},
};

constexpr ConstantRow LIGHT_SAMPLERS[] = {
    {{"power", "in proportion to each light's power"}, shared::LIGHT_SAMPLER_POWER},
    {{"uniform", "every light as often as any other"}, shared::LIGHT_SAMPLER_UNIFORM},
    {{"tree", "by what it may bring to the point: a hierarchy over lights"}, shared::LIGHT_SAMPLER_TREE},
    {{"visibility", "tree times the visibility that is learned in a pass before: for rooms behind rooms"},
     shared::LIGHT_SAMPLER_VISIBILITY},
};

// With few lights the tree's decisions cost more than they gain (shaders/lights/README.md).
constexpr std::uint32_t FEW_LIGHTS = 4;
constexpr Choice LIGHT_SAMPLER_BY_COUNT{"auto", "tree, or power where there are no more than four lights"};

constexpr ConstantRow SAMPLERS[] = {
    {{"sobol", "scrambled Sobol points: each pixel's samples spread evenly"}, shared::SAMPLER_SOBOL},
    {{"blue-noise", "and neighbours' too, so that errors look like fine grain (for few samples)"},
     shared::SAMPLER_BLUE_NOISE},
    {{"independent", "plain random numbers: the baseline"}, shared::SAMPLER_INDEPENDENT},
};

constexpr ConstantRow NAIVE_SAMPLINGS[] = {
    {{"bsdf", "as the surface scatters"}, shared::NAIVE_BSDF},
    {{"cosine", "by the cosine around the normal: mirrors stay black"}, shared::NAIVE_COSINE},
};

constexpr ConstantRow TRIANGLE_SAMPLINGS[] = {
    {{"auto", "by solid angle where emissive triangles are large for the scene"}, TRIANGLES_AS_THEY_ARE},
    {{"solid-angle", "evenly over the directions in which one is seen"}, TRIANGLES_WIDE},
    {{"area", "evenly over its area: quicker, noisier near large ones"}, TRIANGLES_SMALL},
};

constexpr ConstantRow SHADINGS[] = {
    {{"smooth", "irradiance interpolated between patches' corners"},
     static_cast<std::uint32_t>(Shading::smooth)},
    {{"flat", "patches of constant radiance"}, static_cast<std::uint32_t>(Shading::flat)},
    {{"gather", "one bounce of path tracing that sees patches: a final gather"},
     static_cast<std::uint32_t>(Shading::gather)},
};

constexpr ConstantRow ENVIRONMENT_SAMPLINGS[] = {
    {{"auto", "compensated with strategy mis, else radiance"}, ENVIRONMENT_BY_STRATEGY},
    {{"radiance", "in proportion to radiance"}, ENVIRONMENT_RADIANCE},
    {{"compensated", "to what it has above its mean: strategy mis finds the rest by BSDF sampling"},
     ENVIRONMENT_COMPENSATED},
};

constexpr ConstantRow FILTERS[] = {
    {{"box", "the pixel's square (radius 0.5)"}, shared::FILTER_BOX},
    {{"gaussian", "a bell cut at its radius (1.5)"}, shared::FILTER_GAUSSIAN},
    {{"blackman-harris", "Cycles' default (radius 1.5)"}, shared::FILTER_BLACKMAN_HARRIS},
};

template <class Row, std::size_t N> constexpr std::array<Choice, N> choices_of(const Row (&rows)[N]) {
    std::array<Choice, N> choices{};
    for (std::size_t i = 0; i < N; ++i) choices[i] = rows[i].choice;
    return choices;
}

constexpr auto INTEGRATOR_CHOICES = choices_of(INTEGRATORS);
constexpr auto STRATEGY_CHOICES = choices_of(STRATEGIES);
constexpr auto HEURISTIC_CHOICES = choices_of(HEURISTICS);
constexpr auto LIGHT_RAY_CHOICES = choices_of(LIGHT_RAYS);
constexpr auto LIGHT_SAMPLER_CHOICES = choices_of(LIGHT_SAMPLERS);
constexpr auto LIGHT_SAMPLER_OPTIONS = [] {
    std::array<Choice, 1 + std::size(LIGHT_SAMPLERS)> options{LIGHT_SAMPLER_BY_COUNT};
    for (std::size_t i = 0; i < std::size(LIGHT_SAMPLERS); ++i) options[1 + i] = LIGHT_SAMPLERS[i].choice;
    return options;
}();
constexpr auto SAMPLER_CHOICES = choices_of(SAMPLERS);
constexpr auto NAIVE_SAMPLING_CHOICES = choices_of(NAIVE_SAMPLINGS);
constexpr auto TRIANGLE_SAMPLING_CHOICES = choices_of(TRIANGLE_SAMPLINGS);
constexpr auto SHADING_CHOICES = choices_of(SHADINGS);
constexpr auto ENVIRONMENT_SAMPLING_CHOICES = choices_of(ENVIRONMENT_SAMPLINGS);
constexpr auto FILTER_CHOICES = choices_of(FILTERS);

template <class Row>
const Row& find(std::span<const Row> rows, std::string_view what, std::string_view name) {
    std::string known;
    for (const Row& row : rows) {
        if (row.choice.name == name) return row;
        known += known.empty() ? row.choice.name : std::string(", ") + row.choice.name;
    }
    throw Error(fmt::format("{} '{}': there is none of that name (there are: {})", what, name, known));
}

} // namespace

std::span<const Choice> integrators() { return INTEGRATOR_CHOICES; }
std::span<const Choice> strategies() { return STRATEGY_CHOICES; }
std::span<const Choice> heuristics() { return HEURISTIC_CHOICES; }
std::span<const Choice> light_ray_choices() { return LIGHT_RAY_CHOICES; }
std::span<const Choice> light_samplers() { return LIGHT_SAMPLER_CHOICES; }
std::span<const Choice> light_sampler_options() { return LIGHT_SAMPLER_OPTIONS; }
std::span<const Choice> samplers() { return SAMPLER_CHOICES; }
std::span<const Choice> naive_samplings() { return NAIVE_SAMPLING_CHOICES; }
std::span<const Choice> triangle_samplings() { return TRIANGLE_SAMPLING_CHOICES; }
std::span<const Choice> shadings() { return SHADING_CHOICES; }
std::span<const Choice> environment_samplings() { return ENVIRONMENT_SAMPLING_CHOICES; }
std::span<const Choice> pixel_filters() { return FILTER_CHOICES; }

const IntegratorRow& find_integrator(std::string_view name) {
    return find(std::span<const IntegratorRow>(INTEGRATORS), "integrator", name);
}
std::uint32_t find_strategy(std::string_view name) {
    return find(std::span<const ConstantRow>(STRATEGIES), "strategy", name).constant;
}
std::uint32_t find_heuristic(std::string_view name) {
    return find(std::span<const ConstantRow>(HEURISTICS), "heuristic", name).constant;
}
std::uint32_t find_light_rays(std::string_view name) {
    return find(std::span<const ConstantRow>(LIGHT_RAYS), "light rays", name).constant;
}
std::uint32_t find_light_sampler(std::string_view name) {
    return find(std::span<const ConstantRow>(LIGHT_SAMPLERS), "light sampler", name).constant;
}
std::string choose_light_sampler(std::string_view name, std::uint32_t lights) {
    if (name != LIGHT_SAMPLER_BY_COUNT.name) return std::string(name);
    return lights > FEW_LIGHTS ? "tree" : "power";
}
bool learns_visibility(const RenderSettings& s) { return s.light_sampler == "visibility"; }
std::uint32_t find_sampler(std::string_view name) {
    return find(std::span<const ConstantRow>(SAMPLERS), "sampler", name).constant;
}
std::uint32_t find_naive_sampling(std::string_view name) {
    return find(std::span<const ConstantRow>(NAIVE_SAMPLINGS), "naive sampling", name).constant;
}
Shading find_shading(std::string_view name) {
    return static_cast<Shading>(find(std::span<const ConstantRow>(SHADINGS), "shading", name).constant);
}
std::uint32_t choose_triangle_sampling(std::string_view name, std::uint32_t features) {
    const std::uint32_t wanted =
        find(std::span<const ConstantRow>(TRIANGLE_SAMPLINGS), "triangle sampling", name).constant;
    if (wanted == TRIANGLES_AS_THEY_ARE || (features & shared::FEATURE_EMISSIVE_TRIANGLES) == 0)
        return features;
    const std::uint32_t others = features & ~shared::FEATURE_WIDE_TRIANGLES;
    return wanted == TRIANGLES_WIDE ? others | shared::FEATURE_WIDE_TRIANGLES : others;
}

EnvironmentDensity choose_environment_sampling(const RenderSettings& s) {
    const std::uint32_t wanted = find(std::span<const ConstantRow>(ENVIRONMENT_SAMPLINGS),
                                      "environment sampling", s.environment_sampling)
                                     .constant;
    const std::uint32_t strategy = find_strategy(s.strategy);
    if (wanted == ENVIRONMENT_COMPENSATED && strategy == shared::STRATEGY_LIGHT)
        throw Error(
            "environment sampling 'compensated': strategy 'light' would miss the dim parts of the map "
            "(use strategy 'mis', or environment sampling 'radiance')");
    return wanted != ENVIRONMENT_RADIANCE && strategy == shared::STRATEGY_MIS
               ? EnvironmentDensity::compensated
               : EnvironmentDensity::radiance;
}

} // namespace ajar
