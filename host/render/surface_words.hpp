// SurfaceRecord and SurfaceExtension of one triangle.
#pragma once

#include "scene/scene.hpp"

#include <cstdint>

namespace ajar {

// Writes the record's words (SURFACE_TEXELS or SURFACE_EXTENDED_TEXELS times four) of triangle `triangle` of
// the mesh, with directions taken to the frame of `to_frame`. The vertex order is swapped where to_frame
// mirrors, as positions'.
void write_surface_words(const Mesh& mesh, std::uint32_t triangle, const glm::mat4& to_frame,
                         std::uint32_t object, bool extended, std::uint32_t* words);

} // namespace ajar
