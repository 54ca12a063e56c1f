// What is known of elements, by element, once their light has been computed.
#pragma once

#include "bake/surface_means.hpp"
#include "render/render.hpp"

#include <glm/gtc/constants.hpp>

namespace ajar {

struct ElementLight {
    std::vector<glm::vec3> irradiance; // W/m^2
    ElementMaterials materials;
    std::vector<TextureMean> textures;

    glm::vec3 reflected(std::size_t element) const { // radiance, W/(m^2 sr)
        return materials.reflectance[element] * irradiance[element] * glm::one_over_pi<float>();
    }
};

} // namespace ajar
