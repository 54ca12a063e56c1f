// Materials and textures as the device reads them.
#pragma once

#include "scene/scene.hpp"
#include "shaders/shared/material.glsl.h"

#include <cstdint>
#include <vector>

namespace ajar {

struct MaterialTable {
    std::vector<shared::MaterialRecord> materials; // Scene::materials, in order
    std::vector<shared::TextureRecord> textures;   // one per use of a texture by a material
    std::vector<std::uint32_t> texels;             // RGBA8 of every image that is used, one after the other
    std::uint32_t features = 0;                    // FEATURE_* bits that materials decide
    bool uses_uv1 = false;
};

// Throws Error when the textures have more texels than 32 bits can count.
MaterialTable build_material_table(const Scene& scene);

// TRIANGLE_*: what rays have to know of triangles of this material before they look at it.
std::uint32_t triangle_flags(const Material& material, bool cull_backfaces);

} // namespace ajar
