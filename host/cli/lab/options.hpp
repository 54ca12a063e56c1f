// The options of `ajar lab`, and what they amount to before anything is opened.
#pragma once

#include "cli/lab/cases.hpp"
#include "cli/render_options.hpp"
#include "image/canvas.hpp"

#include <array>
#include <string>
#include <vector>

namespace ajar::cli {

// How long a case is rendered: the one that is not 0 counts.
struct Budget {
    std::uint32_t samples = 0; // per pixel
    double seconds = 0;
};

struct LabOptions {
    RenderOptions render; // scene, image, display and device; settings.samples is for equal samples
    std::string folder = "lab";
    std::vector<std::string> lists;      // one per axis
    std::vector<std::string> cases;      // "NAME: --options"
    double seconds = 0;                  // 0: equal samples
    std::string reference;               // a file; empty: rendered
    std::uint32_t reference_samples = 0; // 0: REFERENCE_FACTOR times the cases' budget
    std::string reference_options;
    std::string cache; // folder of references; empty: `folder`
    std::vector<std::string> insets;
    std::string sheet_samples;
    std::string title;
    bool dry_run = false;
};

// A reference of so many times the samples adds a sixteenth to the error of an estimator as good as its own.
inline constexpr std::uint32_t REFERENCE_FACTOR = 16;

struct LabPlan {
    std::vector<Case> cases; // no two of one name
    Budget budget;
    Budget reference_budget;
    RenderSettings reference_settings;
    std::vector<std::uint32_t> stops;          // samples at which the contact sheet wants pictures
    bool automatic_insets = true;              // else:
    std::vector<std::array<double, 4>> insets; // x, y, width, height: of the picture's size
};

void declare(CLI::App& app, LabOptions& options);
// Throws UsageError for what does not go together.
LabPlan make_plan(const LabOptions& options);

} // namespace ajar::cli
