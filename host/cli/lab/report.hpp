// What `ajar lab` found, as a table for people (Markdown, which reads as text), for spreadsheets and for
// programs.
#pragma once

#include "cli/lab/measure.hpp"
#include "cli/lab/reference.hpp"

#include <string>
#include <vector>

namespace ajar::cli {

struct LabResults {
    std::string title;
    std::string scene; // the file's name
    Budget budget;
    const Reference& reference;
    const std::vector<Measured>& cases;
    bool interrupted = false; // some cases were not rendered
};

std::string as_markdown(const LabResults& results);
std::string as_csv(const LabResults& results);
std::string as_json(const LabResults& results);

// Whether the reference's own noise is in the way of the smallest error; then what to do about it.
std::optional<std::string> reference_warning(const LabResults& results);

} // namespace ajar::cli
