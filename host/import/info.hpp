// What `ajar info` says about a file, for people and for machines.
#pragma once

#include "import/import.hpp"

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace ajar {

// One line per fact; ends with a newline.
std::string info_text(const ImportResult& result);

// The same facts. Counts under "file" are the file's, those under "scene" the chosen scene's; lengths in
// metres.
nlohmann::json info_json(const ImportResult& result);

// A glTF extension that the importer knows.
struct KnownExtension {
    std::string_view name;
    ExtensionSupport support;
    std::string_view help;
};
std::vector<KnownExtension> known_extensions();

std::string_view to_string(ExtensionSupport support);

} // namespace ajar
