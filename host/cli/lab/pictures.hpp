// The contact sheet and the plots of `ajar lab`.
#pragma once

#include "cli/lab/report.hpp"
#include "image/image.hpp"

#include <string>

namespace ajar::cli {

// options: tone mapping; plan: insets and columns.
Image lab_sheet(const LabResults& results, const LabPlan& plan, const SaveOptions& options);

// The square root of relMSE against samples, and against seconds.
std::string plot_over_samples(const LabResults& results);
std::string plot_over_seconds(const LabResults& results);

} // namespace ajar::cli
