// Where a solution wants smaller patches: at shadow edges, and wherever else it changes fast.
#pragma once

#include "radiosity/radiosity.hpp"

#include <cstdint>
#include <vector>

namespace ajar {

// By patch: 1 where what a side reflects differs between its corners, shaded smoothly, by more than
// `threshold` of the mean over all sides (luminance, weighted by area).
std::vector<std::uint8_t> mark_gradients(const RadiositySolution& solution, float threshold);

} // namespace ajar
