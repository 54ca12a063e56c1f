// What a radiosity solution was made of and how it came, for --report and images' metadata.
#pragma once

#include "ajar/session.hpp"

#include <nlohmann/json_fwd.hpp>

namespace ajar {

// What decides the solution, and what reproduces it.
nlohmann::ordered_json radiosity_settings_json(const RadiosityResult& result);

// All of it: every iteration, energy, reciprocity, times and memory.
nlohmann::ordered_json radiosity_json(const RadiosityResult& result);

} // namespace ajar
