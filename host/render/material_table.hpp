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

// Whether triangles of this material need a test beyond geometry when they are hit.
bool needs_alpha_test(const Material& material, bool cull_backfaces);

} // namespace ajar
