// Materials: metallic-roughness and the extensions that have a row in extensions/table.cpp (glTF 2.0, section
// 3.9).
#pragma once

#include "import/textures.hpp"

namespace ajar::gltf {

// What a material extension's reader gets.
struct MaterialInput {
    const JsonObject& material;
    const JsonObject& extension;
    Textures& textures;
    Document& document;
};

// Appends every material of the file to scene.materials, in order. Textures are read only for those marked in
// `is_used`, so that what nobody looks at costs nothing.
void read_materials(Document& document, Textures& textures, const std::vector<bool>& is_used, Scene& scene);

} // namespace ajar::gltf
