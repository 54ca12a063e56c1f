// The texels of an atlas that surfaces cover, and the gutter around them.
#pragma once

#include "bake/atlas.hpp"

namespace ajar {

// A texel and the piece of a triangle that it shows, in the triangle's barycentrics (u of the second vertex,
// v of the third, of its mesh). It reaches beyond the triangle where the texel does, but not beyond the
// rectangle around the chart: there is nothing, and places on the very border of a mesh are where textures
// begin anew.
struct CoveredTexel {
    std::uint32_t texel = 0;    // x + side * y
    std::uint32_t triangle = 0; // Charts::triangles
    glm::vec2 origin{0, 0};     // of the least corner of the texel's square within the chart's rectangle
    glm::vec2 edge_x{0, 0};     // its side along the row
    glm::vec2 edge_y{0, 0};
};

// Every texel whose square touches a triangle, once: of several triangles the one that holds its middle, else
// the nearest. By texel.
std::vector<CoveredTexel> covered_texels(const Atlas& atlas);

// Gives every other texel the mean of its neighbours that have values, ring by ring outwards, so that no
// filter or mip level meets anything that is not light. `values`: by texel; `has_value` likewise.
void fill_gutter(std::vector<glm::vec4>& values, std::vector<bool> has_value, std::uint32_t side);

} // namespace ajar
