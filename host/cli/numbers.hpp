// Checks of options that are numbers.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <limits>

namespace ajar::cli {

inline constexpr double HUGE_NUMBER = std::numeric_limits<float>::max();

// A finite number from `low` to `high`; without a description, which CLI11 would put into the help's option
// names.
CLI::Validator number(double low, double high);

CLI::Validator count(std::uint32_t low, std::uint32_t high = std::numeric_limits<std::uint32_t>::max());

} // namespace ajar::cli
