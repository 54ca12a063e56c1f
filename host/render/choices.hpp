// Names to what they stand for; each throws Error that lists the known names.
#pragma once

#include "render/environment_table.hpp"
#include "render/settings.hpp"

#include <cstdint>
#include <string>
#include <string_view>

namespace ajar {

struct IntegratorRow;

const IntegratorRow& find_integrator(std::string_view name);
std::uint32_t find_strategy(std::string_view name);      // STRATEGY_*
std::uint32_t find_heuristic(std::string_view name);     // HEURISTIC_*
std::uint32_t find_light_rays(std::string_view name);    // SHADE_WHOLE: to one; SHADE_LIGHT: to all
std::uint32_t find_light_sampler(std::string_view name); // LIGHT_SAMPLER_*
// The row of light_samplers() that a row of light_sampler_options() means for so many lights.
std::string choose_light_sampler(std::string_view name, std::uint32_t lights);
// Whether those settings need a pass that learns visibility.
bool learns_visibility(const RenderSettings& settings);
std::uint32_t find_sampler(std::string_view name);        // SAMPLER_*
std::uint32_t find_naive_sampling(std::string_view name); // NAIVE_*

// How integrator radiosity shows patches.
enum class Shading : std::uint32_t { smooth, flat, gather };
Shading find_shading(std::string_view name);

// The FEATURE_* bits of a scene with FEATURE_WIDE_TRIANGLES as the row of triangle_samplings() wants it.
std::uint32_t choose_triangle_sampling(std::string_view name, std::uint32_t features);
// What the row of environment_samplings() means for those settings. Throws Error also where it would miss
// light.
EnvironmentDensity choose_environment_sampling(const RenderSettings& settings);

} // namespace ajar
