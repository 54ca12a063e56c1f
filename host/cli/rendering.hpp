// What every command that renders begins with, and what it has to say about the result. Decided here and
// nowhere else: the default environment, and where compiled pipelines are kept.
#pragma once

#include "ajar/ajar.hpp"
#include "cli/progress.hpp"
#include "cli/render_options.hpp"

#include <string_view>

namespace ajar::cli {

// Throws UsageError for settings that exclude each other. `what`: begins the line.
void expect_possible(const RenderSettings& settings, std::string_view what = "");

// `display` must outlive the device, the options outlive the scene.
Device open_device(RenderOptions& options, ProgressDisplay& display);
SceneFile load_scene(RenderOptions& options, ProgressDisplay& display);
SceneFile read_scene(RenderOptions& options, ProgressDisplay& display); // however dark it is

// A picture may look right and still lack something. `what`: begins the lines, such as "mis: ".
void warn_of_losses(const RenderResult& result, ProgressDisplay& display, std::string_view what = "");

} // namespace ajar::cli
