// Every glTF extension the importer knows: what `ajar info` prints and what extensionsRequired is checked
// against.
#pragma once

#include "import/import.hpp"
#include "import/materials.hpp"

namespace ajar::gltf {

struct Extension {
    std::string_view name;
    ExtensionSupport support;
    std::string_view help; // one line
    // For an extension of materials: changes what the core properties gave. Null for the others.
    void (*read_material)(const MaterialInput& input, Material& material) = nullptr;
};

std::span<const Extension> extension_table();

// How an extension is treated; one without a row is ignored.
ExtensionSupport extension_support(std::string_view name);

// Fills info().extensions from extensionsUsed and extensionsRequired. Throws Error for a required one that is
// not supported, warns about the others.
void check_extensions(Document& document);

} // namespace ajar::gltf
