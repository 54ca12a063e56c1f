// LightRecords of every kind of light (light.glsl.h says what their fields mean).
#pragma once

#include "render/light_table.hpp"

namespace ajar {

// Angle scale and offset of KHR_lights_punctual's recommended spot profile.
glm::vec2 spot_scale_offset(const Light& light);

// Whether a punctual light has an extent that can be told from none.
bool is_soft(const Light& light);

shared::LightRecord triangle_record(const EmissiveTriangle& triangle);
shared::LightRecord sphere_record(const EmissiveSphere& sphere);
shared::LightRecord light_record(const Light& light);

} // namespace ajar
