// What `ajar lab` compares: the combinations of rows of the method tables, and named sets of options of
// `render`.
#pragma once

#include "render/render.hpp"
#include "render/settings.hpp"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ajar::cli {

// A table of methods as a list option. A new one is a row in cases.cpp.
struct Axis {
    const char* option;   // of `ajar lab`
    const char* replaces; // the option of `ajar render` that takes one name
    const char* what;     // for --help
    std::string RenderSettings::*setting;
    std::span<const Choice> (*choices)();
    // False where the setting changes nothing, so that such combinations are rendered once.
    bool (*matters)(const RenderSettings& settings);
};
std::span<const Axis> axes();

struct Case {
    std::string name;
    RenderSettings settings;
};

// The names in a comma list, "all" being every row. Throws UsageError naming the option.
std::vector<std::string> parse_names(const Axis& axis, const std::string& list);

// Every combination of `chosen` (one list per axis; an empty one leaves base's), the first axis slowest.
// The names tell what differs.
std::vector<Case> combinations(const RenderSettings& base,
                               const std::vector<std::vector<std::string>>& chosen);

// "NAME: --option value ...": options of `render` on top of `base`. Throws UsageError.
Case parse_case(const std::string& text, const RenderSettings& base);
// The same without a name; `where` begins the errors' lines.
RenderSettings parse_settings(const std::string& text, const RenderSettings& base, const std::string& where);

} // namespace ajar::cli
