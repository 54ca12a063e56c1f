// How long a sequence the blue-noise sampler lays out over the picture.
#pragma once

#include "render/settings.hpp"

#include <cstdint>

namespace ajar {

// Samples per pixel, a power of two; 0 for samplers whose sequences have no end. Throws Error where the
// settings ask for samples beyond it, or for more than a sequence can have.
std::uint32_t sequence_samples(const RenderSettings& settings);

} // namespace ajar
