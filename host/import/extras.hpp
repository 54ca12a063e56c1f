// What Ajar reads from `extras`, where glTF lets every application keep what it likes: nothing in there
// makes a file unreadable. A value that cannot be used is warned about, and counts as missing.
#pragma once

#include "import/document.hpp"

#include <optional>
#include <string_view>

namespace ajar::gltf {

// A number above 0 and at most `highest`. `owner`, in the warning: "light 'lamp'".
std::optional<float> extras_number(Document& document, const JsonObject& object, std::string_view key,
                                   float highest, std::string_view owner);

bool extras_flag(Document& document, const JsonObject& object, std::string_view key, std::string_view owner);

} // namespace ajar::gltf
