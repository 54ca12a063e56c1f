// Materials that show what is baked, and scenes without what nothing uses.
#pragma once

#include "scene/scene.hpp"

namespace ajar {

// KHR_materials_unlit with the original's name, alpha and sides. Programs that do not know the extension are
// to see something dull, as its text advises.
Material unlit_material(const Material& original, const glm::vec4& base_color,
                        const TextureUse& base_color_texture);

// Leaves out materials, textures and images that no triangle uses; those that are left keep their order.
void remove_unused(Scene& scene);

} // namespace ajar
